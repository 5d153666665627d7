// Textures and height fields.
#pragma once

#include <pugixml.hpp>

#include "scene/limits.h"

namespace mimo::scene {

// Both throw as check() does.
void check_texture(pugi::xml_node texture, const Limits& limits);
void check_height_field(pugi::xml_node field, const Limits& limits);

}  // namespace mimo::scene
