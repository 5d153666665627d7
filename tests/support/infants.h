// Infants' bodies in numbers.
#pragma once

#include <map>
#include <string>

#include "growth/growth.h"
#include "growth/skeleton.h"
#include "scene/anatomy.h"
#include "scene/scene.h"
#include "scene/xml.h"
#include "support/scenes.h"

namespace mimo::test {

// A built-in body at 18 months, as scenes read it.
inline const growth::Skeleton& infant(const std::string& body) {
  static std::map<std::string, growth::Skeleton> bodies;
  const auto known = bodies.find(body);
  if (known != bodies.end()) return known->second;
  scene::Scene scene(named("benchmark"));
  scene.add_body(body, "", nullptr);
  const pugi::xml_document document = scene::parse(scene.xml(), body);
  return bodies.emplace(body, scene::Anatomy(document.document_element(), "").skeleton()).first->second;
}

inline growth::Growth aged(double months) {
  growth::Growth growth;
  growth.age = growth.physiological_age = months;
  return growth;
}

}  // namespace mimo::test
