#include "scene/attachments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/fail.h"
#include "document/compiler.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/xml.h"
#include "engine/physics.h"
#include "scene/recipe.h"

namespace mimo::scene {
namespace {

pugi::xml_node only_body(pugi::xml_node root, const std::string& what) {
  pugi::xml_node body;
  int count = 0;
  for (const pugi::xml_node world : root.children("worldbody")) {
    for (const pugi::xml_node child : world.children("body")) {
      body = child;
      ++count;
    }
  }
  if (count != 1) fail(Status::kModel, "{}: its worldbody has {} bodies, expected one", what, count);
  return body;
}

// What else the document has in its world, such as a floor or a lamp for looking at it alone, does not come along.
void keep_only(pugi::xml_node root, pugi::xml_node body) {
  for (pugi::xml_node world = root.child("worldbody"); world;) {
    const pugi::xml_node next = world.next_sibling("worldbody");
    if (body.parent() != world) root.remove_child(world);
    world = next;
  }
  pugi::xml_node world = body.parent();
  for (pugi::xml_node child = world.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child != body) world.remove_child(child);
    child = next;
  }
}

bool is_free(pugi::xml_node joint, const document::Defaults& defaults) {
  if (std::string(joint.name()) == "freejoint") return true;
  return std::string(joint.name()) == "joint" && std::string(defaults.find(joint, "type").value()) == "free";
}

// How the body moves: by joints of its own; by a free joint, if it has none; or not at all.
void set_freedom(pugi::xml_node body, const document::Defaults& defaults, const Model& model, const std::string& what) {
  bool has_joint = false;
  for (const pugi::xml_node child : body.children()) {
    const bool free = is_free(child, defaults);
    require(!free || !model.fixed, "{}: fixed is 1, but its body has a free joint", what);
    has_joint = has_joint || free || std::string(child.name()) == "joint";
  }
  if (!has_joint && !model.fixed) document::set(document::append(body, "freejoint"), "name", model.name);
}

document::Pose pose_of(const engine::Physics& physics, const std::string& body) {
  const int id = engine::find_or_fail(physics.model(), engine::Kind::kBody, body);
  document::Pose pose;
  std::copy_n(physics.data().xpos + 3 * id, 3, pose.position.begin());
  std::copy_n(physics.data().xquat + 4 * id, 4, pose.orientation.begin());
  return pose;
}

}  // namespace

void become_object(pugi::xml_document& document, pugi::xml_node host, const Model& model,
                   const document::Limits& limits) {
  const std::string what = "model \"" + model.name + "\"";
  const pugi::xml_node root = document.document_element();
  pugi::xml_node body = only_body(root, what);
  document::weigh_alone(document, what, limits);
  keep_only(root, body);
  document::adapt(root, host, what);
  document::name_main_defaults(root, "main");
  document::prefix_all_names(root, model.name + "/");
  if (!body.attribute("name")) document::set(body, "name", model.name);
  document::set_pose(body, model.pose);
  set_freedom(body, document::Defaults(root), model, what);
}

void require_bodies(pugi::xml_node root, const Weld& weld) {
  const std::vector<std::string> names = document::names_of(root, {"body"});
  for (const std::string& body : {weld.body, weld.other}) {
    if (body == "world" || std::find(names.begin(), names.end(), body) != names.end()) continue;
    fail(Status::kNotFound, "no body named \"{}\"; {}", body, choice_of(body, names));
  }
  require(weld.body != weld.other, "body and other are both \"{}\", expected two bodies", weld.body);
}

void add_weld(pugi::xml_node root, const Weld& weld, const document::Pose& pose) {
  const pugi::xml_node node = add_equality(root, "weld");
  document::set(node, "body1", weld.other);
  document::set(node, "body2", weld.body);
  const auto& [p, q] = pose;
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const std::array<double, 7> numbers{p[0], p[1], p[2], q[0] / length, q[1] / length, q[2] / length, q[3] / length};
  document::set(node, "relpose", Span<const double>(numbers));
}

void add_start_welds(pugi::xml_node root, const std::vector<Weld>& welds, const engine::ModelPtr& model) {
  const engine::Physics physics = at_start(model);
  for (const Weld& weld : welds) {
    add_weld(root, weld, document::seen_from(pose_of(physics, weld.other), pose_of(physics, weld.body)));
  }
}

pugi::xml_node add_equality(pugi::xml_node root, const char* kind) {
  const pugi::xml_node equality = document::append(document::section(root, "equality"), kind);
  document::set(equality, "active", "true");
  document::set(equality, "solref", "0.02 1");
  document::set(equality, "solimp", "0.9 0.95 0.001 0.5 2");
  return equality;
}

}  // namespace mimo::scene
