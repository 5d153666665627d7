#include "scene/equalities.h"

#include "document/xml.h"

namespace mimo::scene {

pugi::xml_node add_equality(pugi::xml_node root, const char* kind) {
  const pugi::xml_node equality = document::append(document::section(root, "equality"), kind);
  document::set(equality, "active", "true");
  document::set(equality, "solref", "0.02 1");
  document::set(equality, "solimp", "0.9 0.95 0.001 0.5 2");
  return equality;
}

}  // namespace mimo::scene
