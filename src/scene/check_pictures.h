// Textures, height fields and the pictures that shadows are made of.
#pragma once

#include <pugixml.hpp>

#include "scene/limits.h"

namespace mimo::scene {

// Both throw as check() does.
void check_texture(pugi::xml_node texture, const Limits& limits);
void check_height_field(pugi::xml_node field, const Limits& limits);
void check_shadows(pugi::xml_node quality, const Limits& limits);

}  // namespace mimo::scene
