// Meshes and skins.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "document/budget.h"
#include "document/defaults.h"
#include "document/limits.h"
#include "document/mesh_data.h"

namespace mimo::document {

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

}  // namespace mimo::document
