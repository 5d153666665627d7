// Names of a document's elements: looked up, listed, and told apart from another's by a prefix.
#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace mimo::document {

// Throws for a name that cannot go before others: anything but letters, digits, '_', '-' and '.'.
void require_plain(const std::string& name);

// Prefixes the names of bodies, joints, geoms, ... of a body's document and all references to them. Names of
// default classes and assets stay: they are shared by all infants.
void prefix_names(pugi::xml_node root, const std::string& prefix);

// Prefixes those of default classes and assets as well. Assets that are called after their file get that name first.
void prefix_all_names(pugi::xml_node root, const std::string& prefix);

// An asset without a name is called after its file; this gives it that name in writing.
void name_after_file(pugi::xml_node asset);
// "horse" of "meshes/horse.stl": what an asset without a name is called.
std::string stem_of(const std::string& path);

// The element of that name; empty if there is none.
pugi::xml_node find_named(pugi::xml_node root, const char* element, const std::string& name);

// Names of the document's bodies, joints, ..., in its order.
std::vector<std::string> names_of(pugi::xml_node root, std::initializer_list<const char*> elements);

// The first element of a document whose name an element of the same kind in another has, "geom \"floor\""; "" if none.
std::string shared_name(pugi::xml_node one, pugi::xml_node other);

// Whether anything has a name that starts so.
bool has_names_with(pugi::xml_node root, const std::string& prefix);
// Prefixes the default classes of a body's document and all uses of them, for a scene that has classes of these names.
void prefix_classes(pugi::xml_node root, const std::string& prefix);

}  // namespace mimo::document
