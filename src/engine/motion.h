// How places on bodies move: what MuJoCo's sensors would say if the model had any there.
#pragma once

#include <Eigen/Core>

#include "engine/model.h"

typedef struct mjData_ mjData;

namespace mimo::engine {

// A site, or a body's own frame.
struct Place {
  Kind kind;  // kSite or kBody
  int id;
};

// In the place's own frame, as the last forward dynamics computed them.
struct Motion {
  Eigen::Vector3d acceleration;          // proper: what an accelerometer reads, m/s^2
  Eigen::Vector3d angular_velocity;      // rad/s
  Eigen::Vector3d angular_acceleration;  // rad/s^2
};

Motion motion_of(const mjModel& model, const mjData& data, const Place& place);

// What an accelerometer reads at a point of a body that moves so, given from the place, in its frame.
Eigen::Vector3d acceleration_at(const Motion& motion, const Eigen::Vector3d& point);

}  // namespace mimo::engine
