// How places on bodies move: what MuJoCo's sensors would say if the model had any there.
#pragma once

#include <array>

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
  std::array<double, 3> acceleration;      // proper: what an accelerometer reads, m/s^2
  std::array<double, 3> angular_velocity;  // rad/s
};

Motion motion_of(const mjModel& model, const mjData& data, const Place& place);

}  // namespace mimo::engine
