// Names of one infant's model elements, told apart from another's by a prefix.
#pragma once

#include <pugixml.hpp>
#include <string>

namespace mimo::scene {

// Prefixes the names of bodies, joints, geoms, ... of a body's document and all references to them. Names of
// default classes and assets stay: they are shared by all infants.
void prefix_names(pugi::xml_node root, const std::string& prefix);

// Prefixes the default classes of a body's document and all uses of them, for a scene that has classes of these names.
void prefix_classes(pugi::xml_node root, const std::string& prefix);

}  // namespace mimo::scene
