#include "scene/surroundings.h"

#include <algorithm>
#include <vector>

#include "base/names.h"
#include "document/names.h"
#include "document/xml.h"
#include "scene/recipe.h"

namespace mimo::scene {
namespace {

// The first `count` numbers of an attribute; the rest stays.
void scale(pugi::xml_node node, const char* name, double factor, std::size_t count = 3) {
  std::vector<double> values = document::numbers(node.attribute(name));
  if (values.empty()) return;
  for (std::size_t i = 0; i < std::min(count, values.size()); ++i) values[i] *= factor;
  document::set(node, name, Span<const double>(values));
}

// A fastening to the world says where, seen from the infant's part.
void scale_fastenings(pugi::xml_node root, const std::string& prefix, double factor) {
  const pugi::xml_node infant = document::find_named(root, "body", prefix + names::kRootBody);
  for (const pugi::xml_node section : root.children("equality")) {
    for (const pugi::xml_node weld : section.children("weld")) {
      const bool own = !document::find_named(infant, "body", weld.attribute("body1").value()).empty();
      if (own && weld.attribute("body2").empty()) scale(weld, "relpose", factor);
    }
  }
}

void scale_all(pugi::xml_node body, double factor) {
  document::walk(body, [&](pugi::xml_node node) {
    for (const char* length : {"pos", "size", "fromto"}) scale(node, length, factor, 6);
  });
}

}  // namespace

void fit_to_stature(pugi::xml_node root, const std::string& prefix, double stature) {
  const std::vector<std::string> built = custom_words(root, prefix + names::kWithStature);
  if (built.empty()) return;
  for (const std::string& name : built) scale_all(document::find_named(root, "body", prefix + name), stature);
  scale_fastenings(root, prefix, stature);
  scale(document::find_named(root, "body", prefix + names::kRootBody), "pos", stature, 2);
  scale(document::find_named(root, "numeric", prefix + names::kRootPose), "data", stature, 2);
}

void fit_to_arm(pugi::xml_node root, const std::string& prefix, double arm, const Reference& reference) {
  const std::vector<std::string> pairs = custom_words(root, prefix + names::kWithArm);
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    pugi::xml_node body = document::find_named(root, "body", prefix + pairs[i]);
    std::vector<double> place = document::numbers(body.attribute("pos"));
    if (place.size() != 3) continue;  // taken away, or moved by its owner in another way
    const auto was = reference.was(pairs[i + 1]), is = reference.is(pairs[i + 1]);
    for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = is[axis] + arm * (place[axis] - was[axis]);
    document::set(body, "pos", Span<const double>(place));
  }
}

}  // namespace mimo::scene
