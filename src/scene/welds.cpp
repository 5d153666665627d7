#include "scene/welds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/choice.h"
#include "base/fail.h"
#include "document/names.h"
#include "document/xml.h"
#include "engine/physics.h"
#include "scene/equalities.h"
#include "scene/placing.h"

namespace mimo::scene {
namespace {

document::Pose pose_of(const engine::Physics& physics, const std::string& body) {
  const int id = engine::find_or_fail(physics.model(), engine::Kind::kBody, body);
  document::Pose pose;
  std::copy_n(physics.data().xpos + 3 * id, 3, pose.position.begin());
  std::copy_n(physics.data().xquat + 4 * id, 4, pose.orientation.begin());
  return pose;
}

}  // namespace

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

}  // namespace mimo::scene
