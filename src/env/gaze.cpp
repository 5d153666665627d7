#include "env/gaze.h"

#include "engine/present.h"

namespace mimo::env {
namespace {

body::Eyes eyes_of(const World& world, std::size_t agent) {
  return body::Eyes(world.model(), world.agents()[agent].body);
}

}  // namespace

body::Gaze gaze(const World& world, std::size_t agent) { return eyes_of(world, agent).gaze(world.data()); }

body::Look look(const World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head) {
  const body::Eyes eyes = eyes_of(world, agent);
  engine::Present present;
  return eyes.look_at(world.model(), present.of(world.physics()), point, turn_head);
}

body::Look look_at(World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head) {
  body::Look wanted = look(world, agent, point, turn_head);
  engine::Physics& physics = world.physics();
  for (const body::JointAngle& joint : wanted.angles) physics.data().qpos[joint.qpos] = joint.angle;
  physics.update_poses();
  return wanted;
}

}  // namespace mimo::env
