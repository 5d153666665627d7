// Textures, height fields and the pictures that shadows are made of.
#pragma once

#include <pugixml.hpp>

#include "document/budget.h"
#include "document/limits.h"

namespace mimo::document {

// They throw as check() does.
void check_texture(pugi::xml_node texture, const Limits& limits, Budget& budget);
void check_height_field(pugi::xml_node field, const Limits& limits, Budget& budget);
void check_shadows(pugi::xml_node quality, const Limits& limits);

}  // namespace mimo::document
