#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "document/compiler.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/other_versions.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

// A number that position actuators have; all kinds of actuators share their defaults, but not what their words mean.
double own_number(const Defaults& defaults, pugi::xml_node position, const char* name, double otherwise) {
  const pugi::xml_node giver = defaults.giver(position, name);
  const std::vector<double> given = is(giver, "position") ? numbers(giver.attribute(name)) : std::vector<double>();
  return given.empty() ? otherwise : given[0];
}

void become_general(pugi::xml_node position, double kp, double kv, double time_constant) {
  if (!position.set_name("general")) throw std::bad_alloc();
  for (const char* name : {"kp", "kv", "timeconst"}) position.remove_attribute(name);
  const std::array<double, 3> bias{0, -kp, -kv};
  set(position, "gaintype", "fixed");
  set(position, "biastype", "affine");
  set(position, "gainprm", Span<const double>(&kp, 1));
  set(position, "biasprm", Span<const double>(bias));
  if (time_constant <= 0) return;
  set(position, "dyntype", "filterexact");  // what is nearest to it comes later
  set(position, "dynprm", Span<const double>(&time_constant, 1));
}

pugi::xml_node joint_of(pugi::xml_node root, pugi::xml_node actuator) {
  for (const pugi::xml_node world : root.children("worldbody")) {
    const pugi::xml_node joint = find_named(world, "joint", actuator.attribute("joint").value());
    if (joint) return joint;
  }
  return {};
}

// The range of control of a motor whose targets are the angles that its joint can have.
void inherit_range(pugi::xml_node root, const Defaults& defaults, pugi::xml_node position) {
  const double share = own_number(defaults, position, "inheritrange", 0);
  const pugi::xml_node joint = position.attribute("joint") ? joint_of(root, position) : pugi::xml_node();
  std::vector<double> range = joint ? numbers(defaults.find(joint, "range")) : std::vector<double>();
  if (share <= 0) return;
  if (range.size() != 2) return set(position, "inheritrange", Span<const double>(&share, 1));  // who looks on, refuses
  const bool slides = std::strcmp(defaults.find(joint, "type").value(), "slide") == 0;
  const double unit = slides || in_radians(root) ? 1 : kDegree;
  const double middle = unit * (range[0] + range[1]) / 2, reach = unit * share * (range[1] - range[0]) / 2;
  const std::array<double, 2> targets{middle - reach, middle + reach};
  set(position, "ctrlrange", Span<const double>(targets));
  position.remove_attribute("inheritrange");
}

void translate_positions(pugi::xml_node root, const Defaults& defaults) {
  std::vector<pugi::xml_node> positions;
  for (const pugi::xml_node section : root.children("actuator")) {
    for (const pugi::xml_node position : section.children("position")) positions.push_back(position);
  }
  std::vector<std::array<double, 4>> all;  // first, as defaults tell actuators apart by their names
  for (const pugi::xml_node position : positions) {
    inherit_range(root, defaults, position);
    all.push_back({own_number(defaults, position, "kp", 1), own_number(defaults, position, "kv", 0),
                   own_number(defaults, position, "timeconst", 0), own_number(defaults, position, "dampratio", 0)});
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto [kp, kv, time_constant, ratio] = all[i];
    if ((kv != 0 || time_constant != 0) && ratio == 0) become_general(positions[i], kp, kv, time_constant);
  }
}

// Classes of which every actuator has got what they said.
void clear_classes(pugi::xml_node root) {
  for (const pugi::xml_node top : root.children("default")) {
    walk(top, [](pugi::xml_node node) {
      if (!is(node, "position") || !is(node.parent(), "default")) return;
      for (const char* name : {"kv", "timeconst", "inheritrange"}) node.remove_attribute(name);
    });
  }
}

// The range of force that a motor gives itself; everything where it is not limited.
std::array<double, 2> own_forces(const Defaults& defaults, pugi::xml_node motor) {
  const std::vector<double> range = numbers(defaults.find(motor, "forcerange"));
  const bool limited = std::strcmp(defaults.find(motor, "forcelimited").value(), "false") != 0;
  if (range.size() == 2 && limited) return {range[0], range[1]};
  return {-HUGE_VAL, HUGE_VAL};
}

// Whether a joint's limit could be given to its motor: it has just one.
bool move_limit(const Defaults& defaults, pugi::xml_node joint, const std::vector<pugi::xml_node>& motors) {
  const std::vector<double> range = numbers(defaults.find(joint, "actuatorfrcrange"));
  const std::string limited = defaults.find(joint, "actuatorfrclimited").value();
  if (range.size() != 2 || limited == "false" || motors.empty()) return true;
  const std::vector<double> gears = numbers(defaults.find(motors[0], "gear"));
  const double gear = gears.empty() ? 1 : gears[0];
  if (motors.size() > 1 || gear == 0) return false;
  const auto [low, high] = own_forces(defaults, motors[0]);
  const std::array<double, 2> forces{std::max(low, std::min(range[0] / gear, range[1] / gear)),
                                     std::min(high, std::max(range[0] / gear, range[1] / gear))};
  if (!(forces[0] < forces[1])) return false;
  set(motors[0], "forcerange", Span<const double>(forces));
  set(motors[0], "forcelimited", "true");
  return true;
}

using Motors = std::map<std::string, std::vector<pugi::xml_node>>;

// Motors by the joint that they move; nothing where some move more than a joint, such as a tendon.
bool find_motors(pugi::xml_node root, Motors& motors) {
  for (const pugi::xml_node section : root.children("actuator")) {
    for (const pugi::xml_node motor : section.children()) {
      if (motor.type() != pugi::node_element) continue;
      const char* name = motor.attribute("joint") ? "joint" : "jointinparent";
      if (!motor.attribute(name)) return false;
      motors[motor.attribute(name).value()].push_back(motor);
    }
  }
  return true;
}

void remove_limit(pugi::xml_node joint) {
  for (const char* name : {"actuatorfrcrange", "actuatorfrclimited"}) joint.remove_attribute(name);
}

void translate_joint_limits(pugi::xml_node root, const Defaults& defaults) {
  Motors motors;
  if (!find_motors(root, motors)) return;
  std::vector<pugi::xml_node> joints;
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      if (is(node, "joint") && defaults.find(node, "actuatorfrcrange")) joints.push_back(node);
    });
  }
  const bool moved = std::all_of(joints.begin(), joints.end(), [&](pugi::xml_node joint) {
    return move_limit(defaults, joint, motors[joint.attribute("name").value()]);
  });
  if (!moved) return;
  std::for_each(joints.begin(), joints.end(), remove_limit);
  for (const pugi::xml_node top : root.children("default")) {
    walk(top, [](pugi::xml_node node) {
      if (is(node, "joint")) remove_limit(node);
    });
  }
}

}  // namespace

void translate_actuators(pugi::xml_node root) {
  const Defaults defaults(root);
  for (const pugi::xml_node section : root.children("actuator")) {
    for (const pugi::xml_node adhesion : section.children("adhesion")) {
      const pugi::xml_attribute range =
          defaults.find(adhesion, "ctrlrange");  // an older reader wants it at the element
      if (range) set(adhesion, "ctrlrange", std::string(range.value()));
    }
  }
  translate_positions(root, defaults);
  clear_classes(root);
  translate_joint_limits(root, defaults);
}

}  // namespace mimo::document
