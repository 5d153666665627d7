#include "scene/names.h"

#include "scene/xml.h"

namespace mimo::scene {
namespace {

// Attributes that name a model element in these sections, or refer to one.
constexpr const char* kSections[] = {"worldbody", "contact", "equality", "tendon", "actuator", "sensor", "custom"};
constexpr const char* kReferences[] = {"name",     "body",          "body1",      "body2",  "joint",  "joint1",
                                       "joint2",   "jointinparent", "geom",       "geom1",  "geom2",  "site",
                                       "sidesite", "cranksite",     "slidersite", "tendon", "target", "objname",
                                       "camera",   "refsite",       "refname"};

}  // namespace

void prefix_names(pugi::xml_node root, const std::string& prefix) {
  if (prefix.empty()) return;
  for (const char* section : kSections) {
    for (const pugi::xml_node top : root.children(section)) {
      walk(top, [&](pugi::xml_node node) {
        for (const char* name : kReferences) {
          const pugi::xml_attribute attribute = node.attribute(name);
          if (!attribute.empty()) set(node, name, prefix + attribute.value());
        }
      });
    }
  }
}

}  // namespace mimo::scene
