// Sizes, counts and files of a document, checked before MuJoCo's compiler, which believes them, sees them.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "document/budget.h"
#include "document/defaults.h"
#include "document/mesh_data.h"

namespace mimo::document {

// Meshes and skins.

// The meshes of one document.
class Meshes {
 public:
  Meshes(pugi::xml_node root, const Limits& limits);

  // Throws as check() does.
  void check(pugi::xml_node mesh, Budget& budget);

 private:
  bool has_hull(pugi::xml_node mesh);
  void scale(pugi::xml_node mesh, MeshData& data);
  void check_hull(pugi::xml_node mesh, MeshData& data, Budget& budget);

  pugi::xml_node root_;
  const Limits& limits_;
  std::optional<std::set<std::string>> touched_;
  std::optional<Defaults> defaults_;
};

// Throws as check() does.
void check_skin(pugi::xml_node skin, const Limits& limits, Budget& budget);

// What MuJoCo's compiler would believe: sizes, counts and files of a document, checked before it sees them.

// Throws Status::kModel, with file and line, for a document that asks for more than the limits allow, or that would
// make the compiler read or write where it must not. What is wrong in other ways is left to the compiler, which says
// so. Returns what the document will cost.
Budget check(pugi::xml_node root, const Limits& limits);

}  // namespace mimo::document
