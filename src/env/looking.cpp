#include "env/looking.h"

namespace mimo::env {
namespace {

body::Eyes eyes_of(const World& world, std::size_t agent) {
  return body::Eyes(world.model(), world.agents()[agent].body);
}

}  // namespace

body::Gaze gaze(const World& world, std::size_t agent) { return eyes_of(world, agent).gaze(world.data()); }

body::Look look(World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head) {
  const body::Eyes eyes = eyes_of(world, agent);
  body::Look wanted;
  world.physics().at_present([&] { wanted = eyes.look_at(world.model(), world.data(), point, turn_head); });
  return wanted;
}

body::Look look_at(World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head) {
  body::Look wanted = look(world, agent, point, turn_head);
  for (const body::JointAngle& joint : wanted.angles) world.physics().data().qpos[joint.qpos] = joint.angle;
  world.physics().update_poses();
  return wanted;
}

}  // namespace mimo::env
