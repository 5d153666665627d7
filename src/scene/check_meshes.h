// Meshes and skins.
#pragma once

#include <pugixml.hpp>

#include "scene/limits.h"

namespace mimo::scene {

// Both throw as check() does.
void check_mesh(pugi::xml_node mesh, pugi::xml_node root, const Limits& limits);
void check_skin(pugi::xml_node skin, const Limits& limits);

}  // namespace mimo::scene
