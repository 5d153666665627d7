// Infants' bodies in numbers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "document/xml.h"
#include "growth/growth.h"
#include "growth/skeleton.h"
#include "scene/anatomy.h"
#include "scene/scene.h"
#include "support/scenes.h"

namespace mimo::test {

// A built-in body at 18 months, as scenes read it.
inline const growth::Skeleton& infant(const std::string& body) {
  static std::map<std::string, growth::Skeleton> bodies;
  const auto known = bodies.find(body);
  if (known != bodies.end()) return known->second;
  scene::Scene scene(named("benchmark"));
  scene.add_body(body, "", nullptr);
  const pugi::xml_document document = document::parse(scene.xml(), body, document::Root::kMujoco);
  return bodies.emplace(body, scene::Anatomy(document.document_element(), "").skeleton()).first->second;
}

inline growth::Growth aged(double months) {
  growth::Growth growth;
  growth.age = growth.physiological_age = months;
  return growth;
}

// Of bones by their names without a side, kg.
inline double mass_of(const growth::Skeleton& skeleton, const std::vector<std::string>& bones) {
  double mass = 0;
  for (const growth::Bone& bone : skeleton.bones) {
    for (const std::string& name : bones) {
      if (growth::without_side(bone.name) != name) continue;
      for (const growth::Geom& geom : bone.geoms) mass += geom.mass;
    }
  }
  return mass;
}

}  // namespace mimo::test
