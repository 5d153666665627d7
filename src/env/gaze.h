// Where an agent's eyes look, and making them look at a point.
#pragma once

#include "body/eyes.h"
#include "env/world.h"

namespace mimo::env {

// All throw what body::Eyes does where the agent has no such eyes.
body::Gaze gaze(const World& world, std::size_t agent);
// What looking at a point takes, from the pose that the world is in now.
body::Look look(const World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head);
// The same, and the joints take their angles.
body::Look look_at(World& world, std::size_t agent, const Eigen::Vector3d& point, bool turn_head);

}  // namespace mimo::env
