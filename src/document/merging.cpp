#include "document/merging.h"

#include <algorithm>
#include <array>

#include "document/defaults.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

// Every kind of actuator but the general one decides about the state by itself, in classes, too.
bool has_state(pugi::xml_node actuator, const Defaults& defaults) {
  const pugi::xml_node decides = defaults.first(
      actuator, [](pugi::xml_node node) { return !is(node, "general") || !node.attribute("dyntype").empty(); });
  const std::string dynamics = decides.attribute("dyntype").value();
  if (is(decides, "general")) return !dynamics.empty() && dynamics != "none";
  return is_one_of(decides, {"muscle", "intvelocity", "cylinder"});
}

struct UserNumbers {
  const char* size;
  std::initializer_list<const char*> elements;
  const char* section;  // instead: all that stands there
};
const std::array<UserNumbers, 8> kUserNumbers = {
    {{"nuser_body", {"body"}, ""},
     {"nuser_jnt", {"joint", "freejoint"}, ""},
     {"nuser_geom", {"geom"}, ""},
     {"nuser_site", {"site"}, ""},
     {"nuser_cam", {"camera"}, ""},
     {"nuser_tendon", {"tendon"}, "tendon"},
     {"nuser_actuator",
      {"general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion"},
      "actuator"},
     {"nuser_sensor", {}, "sensor"}}};

// The most numbers that an element, or one of a default class, has.
int longest(pugi::xml_node root, const UserNumbers& kind) {
  std::size_t most = 0;
  walk(root, [&](pugi::xml_node node) {
    const pugi::xml_attribute user = node.attribute("user");
    if (user && (is(node.parent(), kind.section) || is_one_of(node, kind.elements))) {
      most = std::max(most, numbers(user).size());
    }
  });
  return static_cast<int>(most);
}

}  // namespace

void put_stateful_last(pugi::xml_node root) {
  const Defaults defaults(root);
  std::vector<pugi::xml_node> stateful;
  bool in_order = true;
  for (const pugi::xml_node section : root.children("actuator")) {
    for (const pugi::xml_node actuator : section.children()) {
      if (actuator.type() != pugi::node_element) continue;
      if (has_state(actuator, defaults)) {
        stateful.push_back(actuator);
      } else {
        in_order = in_order && stateful.empty();
      }
    }
  }
  if (in_order) return;
  const pugi::xml_node last = append(root, "actuator");
  for (pugi::xml_node actuator : stateful) {
    copy_into(last, actuator);
    actuator.parent().remove_child(actuator);
  }
}

void fit_user_numbers(pugi::xml_node root) {
  for (const UserNumbers& kind : kUserNumbers) {
    int most = -1;
    for (const pugi::xml_node size : root.children("size")) {
      if (size.attribute(kind.size)) most = std::max(most, size.attribute(kind.size).as_int(-1));
    }
    if (most < 0) continue;  // MuJoCo counts for itself
    const std::string fitting = std::to_string(std::max(most, longest(root, kind)));
    for (const pugi::xml_node size : root.children("size")) {
      if (size.attribute(kind.size)) set(size, kind.size, fitting);
    }
  }
}

}  // namespace mimo::document
