// Built-in pictures, each decoded once in a process: the cubes of one scene name some of them a dozen times, and
// MuJoCo's compiler would decode them each time.
#pragma once

#include <vector>

#include "engine/model.h"

namespace mimo::document {

// What a built-in picture is called when it is decoded; other files keep their names.
std::string decoded_name(const std::string& name);

// In place of those of these built-in files that are pictures, what is decoded of them, which lives as long as the
// library is loaded.
void decode_pictures(std::vector<engine::Asset>& assets);

}  // namespace mimo::document
