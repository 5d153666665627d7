// An infant's body in a document: read as numbers, and numbers written back.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "growth/skeleton.h"

namespace mimo::scene {

class Anatomy {
 public:
  // Throws Status::kNotFound where the document has no infant of that prefix.
  Anatomy(pugi::xml_node root, const std::string& prefix);

  const growth::Skeleton& skeleton() const { return skeleton_; }
  // The body with everything that hangs on it.

  // Writes what differs from the skeleton, and tells whether anything does. The other one has the same parts in the
  // same order.
  bool write(const growth::Skeleton& changed);

 private:
  struct Reader;

  pugi::xml_node root_;
  growth::Skeleton skeleton_;
  std::vector<pugi::xml_node> bones_, geoms_, joints_, marks_, motors_;  // elements, in the skeleton's order
};

}  // namespace mimo::scene
