#include "document/compiler.h"

#include <array>
#include <cctype>

#include "base/fail.h"
#include "base/functions.h"
#include "base/names.h"
#include "base/numbers.h"
#include "document/attributes.h"
#include "document/composition.h"
#include "document/defaults.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

constexpr std::array<const char*, 3> kJointAngles = {"range", "ref", "springref"};

bool in_defaults(pugi::xml_node node) { return is(node.parent(), "default"); }

void scale(pugi::xml_node node, const char* name, double factor, std::size_t first = 0) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (attribute.empty()) return;
  std::vector<double> values = numbers(attribute);
  for (std::size_t i = first; i < values.size(); ++i) values[i] *= factor;
  set(node, name, Span<const double>(values));
}

bool slides(pugi::xml_attribute type) { return std::string(type.value()) == "slide"; }

// Angles are converted where they stand, in classes, too. What a slide gets from a class is no angle, and what others
// get from the class of a slide is not converted there: both get it spelt out.
void part_from_slides(pugi::xml_node root) {
  const Defaults defaults(root);
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      if (!is(node, "joint")) return;
      const bool slide = slides(defaults.find(node, "type"));
      for (const char* name : kJointAngles) {
        const pugi::xml_node giver = defaults.giver(node, name);
        if (giver && (slide || slides(giver.attribute("type")))) set(node, name, giver.attribute(name).value());
      }
      if (slide) set(node, "type", "slide");
    });
  }
}

void convert_angles(pugi::xml_node root, double factor) {
  part_from_slides(root);
  walk(root, [&](pugi::xml_node node) {
    if (is(node, "joint") && !slides(node.attribute("type"))) {
      for (const char* name : kJointAngles) scale(node, name, factor);
    }
    scale(node, "euler", factor);
    scale(node, "axisangle", factor, 3);
  });
}

// Small letters turn about the axes as they have turned already, capitals about those of the parent.
Quaternion from_euler(const std::vector<double>& angles, const std::string& order, double unit) {
  Quaternion whole{1, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = static_cast<std::size_t>(std::tolower(static_cast<unsigned char>(order[i])) - 'x');
    if (axis > 2) fail(Status::kModel, "eulerseq is \"{}\", expected three of x, y, z, X, Y, Z", order);
    Quaternion turn{fixed::cos(angles[i] * unit / 2), 0, 0, 0};
    turn[axis + 1] = fixed::sin(angles[i] * unit / 2);
    whole = order[i] >= 'a' ? product(whole, turn) : product(turn, whole);
  }
  return whole;
}

std::string euler_order(pugi::xml_node root) {
  const std::string order = compiler_setting(root, "eulerseq");
  return order.empty() ? "xyz" : order;
}

void replace_euler(pugi::xml_node root, const std::string& what) {
  const std::string order = euler_order(root);
  if (order.size() != 3) fail(Status::kModel, "eulerseq is \"{}\", expected three of x, y, z, X, Y, Z", order);
  const double unit = in_radians(root) ? 1 : kDegree;
  walk(root, [&](pugi::xml_node node) {
    const pugi::xml_attribute euler = node.attribute("euler");
    if (euler.empty()) return;
    if (in_defaults(node)) {
      fail(Status::kUnsupported,
           "{}: it has euler=\"{}\" in a default class, and its eulerseq differs from the scene's", what,
           euler.value());
    }
    const std::vector<double> angles = numbers(euler);
    if (angles.size() != 3) fail(Status::kModel, "euler=\"{}\": expected three numbers", euler.value());
    set(node, "quat", Span<const double>(from_euler(angles, order, unit)));
    node.remove_attribute("euler");
  });
}

struct Limit {
  const char* flag;
  const char* range;
};

void spell_out(pugi::xml_node element, const Defaults& defaults, std::initializer_list<Limit> limits) {
  for (const Limit& limit : limits) {
    if (defaults.find(element, limit.range) && !defaults.find(element, limit.flag)) set(element, limit.flag, "true");
  }
}

void spell_out_limits(pugi::xml_node root) {
  const Defaults defaults(root);
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      if (is(node, "joint")) spell_out(node, defaults, {{"limited", "range"}});
    });
  }
  for (const pugi::xml_node section : root.children("tendon")) {
    for (const pugi::xml_node tendon : section.children()) spell_out(tendon, defaults, {{"limited", "range"}});
  }
  for (const pugi::xml_node section : root.children("actuator")) {
    for (const pugi::xml_node actuator : section.children()) {
      spell_out(actuator, defaults,
                {{"ctrllimited", "ctrlrange"}, {"forcelimited", "forcerange"}, {"actlimited", "actrange"}});
    }
  }
}

bool has_composite(pugi::xml_node root) {
  return !root.find_node([](pugi::xml_node node) { return is(node, "composite"); }).empty();
}

// With the values that do nothing.
struct Setting {
  const char* name;
  const char* harmless;
};
constexpr std::array<Setting, 9> kSettings = {{{"inertiafromgeom", "auto"},
                                               {"inertiagrouprange", "0 5"},
                                               {"settotalmass", "-1"},
                                               {"boundmass", "0"},
                                               {"boundinertia", "0"},
                                               {"balanceinertia", "false"},
                                               {"exactmeshinertia", "false"},
                                               {"discardvisual", "false"},
                                               {"fusestatic", "false"}}};

std::vector<pugi::xml_node> bodies_of(pugi::xml_node root) {
  std::vector<pugi::xml_node> bodies;
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      if (std::string(node.name()) == "body") bodies.push_back(node);
    });
  }
  return bodies;
}

std::string working_setting(pugi::xml_node root) {
  for (const Setting& setting : kSettings) {
    const std::string value = compiler_setting(root, setting.name);
    if (!value.empty() && value != setting.harmless) return std::string(setting.name) + "=\"" + value + "\"";
  }
  return "";
}

void remove_setting(pugi::xml_node root, const char* name) {
  for (pugi::xml_node compiler : root.children("compiler")) {
    while (compiler.remove_attribute(name)) {
    }
  }
}

std::string name_for(std::size_t body) { return names::kNameless + std::to_string(body); }

// The document as it is, but that every body can be found in the model: none without a name, none fused with another.
engine::ModelPtr compile_with_names(const pugi::xml_document& document, const Limits& limits) {
  pugi::xml_document named = copy(document);
  const pugi::xml_node root = named.document_element();
  remove_setting(root, "fusestatic");
  std::size_t number = 0;
  for (const pugi::xml_node body : bodies_of(root)) {
    if (!body.attribute("name")) set(body, "name", name_for(number));
    ++number;
  }
  return compile_quietly(named, limits);
}

void set_inertia(pugi::xml_node body, const mjModel& model, int id) {
  while (body.remove_child("inertial")) {
  }
  const pugi::xml_node inertial = body.prepend_child("inertial");
  if (inertial.empty()) throw std::bad_alloc();
  set(inertial, "pos", Span<const double>(model.body_ipos + 3 * id, 3));
  set(inertial, "quat", Span<const double>(model.body_iquat + 4 * id, 4));
  set(inertial, "mass", Span<const double>(model.body_mass + id, 1));
  set(inertial, "diaginertia", Span<const double>(model.body_inertia + 3 * id, 3));
}

}  // namespace

std::string compiler_setting(pugi::xml_node root, const char* attribute) {
  std::string value;
  for (pugi::xml_node compiler : root.children("compiler")) {
    if (compiler.attribute(attribute)) value = compiler.attribute(attribute).value();
  }
  return value;
}

bool infers_limits(pugi::xml_node root) { return compiler_setting(root, "autolimits") != "false"; }

bool in_radians(pugi::xml_node root) { return compiler_setting(root, "angle") == "radian"; }

void convert_to_radians(pugi::xml_node root) { convert_angles(root, kDegree); }

void require_local_coordinates(pugi::xml_node root, const std::string& what) {
  if (compiler_setting(root, "coordinate") == "global") {
    fail(Status::kUnsupported, "{} has compiler coordinate=\"global\", expected local coordinates", what);
  }
}

void adapt(pugi::xml_node guest, pugi::xml_node host, const std::string& what) {
  require_local_coordinates(guest, what);
  const bool other_unit = in_radians(guest) != in_radians(host);
  if (other_unit && has_composite(guest)) {
    fail(Status::kUnsupported, "{} has a composite, and its unit of angles differs from the scene's", what);
  }
  if (euler_order(guest) != euler_order(host)) replace_euler(guest, what);
  if (other_unit) convert_angles(guest, in_radians(host) ? kDegree : 1 / kDegree);
  if (infers_limits(guest) && !infers_limits(host)) spell_out_limits(guest);
}

void weigh_alone(pugi::xml_document& document, const std::string& what, const Limits& limits) {
  const pugi::xml_node root = document.document_element();
  const std::string setting = working_setting(root);
  if (setting.empty()) return;
  if (root.find_node([](pugi::xml_node node) { return std::string(node.name()) == "composite"; })) {
    fail(Status::kUnsupported, "{} has a composite and compiler {}, which would also apply to the rest of the scene",
         what, setting);
  }
  const engine::ModelPtr model = compile_with_names(document, limits);
  std::size_t number = 0;
  for (const pugi::xml_node body : bodies_of(root)) {
    const pugi::xml_attribute name = body.attribute("name");
    const std::string found = name ? name.value() : name_for(number);
    set_inertia(body, *model, engine::find_or_fail(*model, engine::Kind::kBody, found));
    ++number;
  }
  for (const Setting& entry : kSettings) remove_setting(root, entry.name);
}

}  // namespace mimo::document
