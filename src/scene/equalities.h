// Equalities that calls add to a document.
#pragma once

#include <pugixml.hpp>

namespace mimo::scene {

// A new "joint" or "weld". Spelt out, so that main defaults of a user's document do not change it: it is on, and holds
// as the infant's own do.
pugi::xml_node add_equality(pugi::xml_node root, const char* kind);

}  // namespace mimo::scene
