#include "tasks/infant.h"

#include <algorithm>

#include "base/fail.h"
#include "base/functions.h"
#include "base/names.h"
#include "engine/contacts.h"

namespace mimo::tasks {
namespace {

constexpr std::array<const char*, 9> kJoints = {"head_swivel",          "head_tilt",          "head_tilt_side",
                                                "left_eye_horizontal",  "left_eye_vertical",  "left_eye_torsional",
                                                "right_eye_horizontal", "right_eye_vertical", "right_eye_torsional"};

constexpr std::size_t kLeftEye = 3;

const body::Joint& joint_of(const mjModel& model, const body::Body& body, const std::string& name) {
  const int id = engine::find_or_fail(model, engine::Kind::kJoint, body.prefix + names::kJoint + name);
  return *std::find_if(body.joints.begin(), body.joints.end(),
                       [=](const body::Joint& joint) { return joint.id == id; });
}

}  // namespace

int target_of(const mjModel& model, const body::Body& body, const char* task, const char* what) {
  const std::string name = body.prefix + "target";
  const int id = engine::find(model, engine::Kind::kBody, name.c_str());
  if (id < 0) {
    fail(Status::kNotFound,
         "task \"{}\" needs a body named \"{}\", {}, and this scene has none: take the built-in scene \"{}\", or add "
         "such a "
         "body to yours",
         task, name, what, task);
  }
  return id;
}

bool presses(const mjModel& model, const mjData& data, int contact) {
  const auto force = engine::contact_force(model, data, contact);
  return std::any_of(force.begin(), force.begin() + 3, [](double component) { return component != 0; });
}

bool touches(const engine::Physics& physics, const std::vector<int>& bodies, int other) {
  for (const engine::Meeting& met : engine::Contacts(physics.model(), physics.data())) {
    const auto [first, second] = met.bodies;
    if (first != other && second != other) continue;
    const int toucher = first == other ? second : first;
    if (std::find(bodies.begin(), bodies.end(), toucher) != bodies.end() &&
        presses(physics.model(), physics.data(), met.number)) {
      return true;
    }
  }
  return false;
}

bool feels(const engine::Physics& physics, int body) {
  for (const engine::Meeting& met : engine::Contacts(physics.model(), physics.data())) {
    const bool its = met.bodies[0] == body || met.bodies[1] == body;
    if (its && presses(physics.model(), physics.data(), met.number)) return true;
  }
  return false;
}

Tracking::Tracking(const mjModel& model, const body::Body& body) : head_(body.head) {
  for (std::size_t i = 0; i < kJoints.size(); ++i) {
    joints_[i] = joint_of(model, body, kJoints[i]);
    addresses_[i] = joints_[i].qpos;
  }
  left_eye_ = Eigen::Vector3d(model.body_pos + 3 * model.jnt_bodyid[joints_[kLeftEye].id]);
}

void Tracking::look_at(const Eigen::Vector3d& point, engine::Physics& physics) const {
  Eigen::Vector3d to = point - position(physics, head_);
  const double distance = to.norm();
  to.z() -= left_eye_.z();
  const double swivel = fixed::atan2(to.y(), to.x());
  const double tilt = fixed::atan2(-to.z(), to.x());
  const double inwards = fixed::atan2(-left_eye_.y(), distance - left_eye_.x());
  const std::array<double, 9> angles = {swivel, tilt, 0, inwards, 0, 0, inwards, 0, 0};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    physics.data().qpos[joints_[i].qpos] = std::clamp(angles[i], joints_[i].low, joints_[i].high);
  }
}

}  // namespace mimo::tasks
