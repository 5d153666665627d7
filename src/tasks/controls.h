// What motors are told.
#pragma once

#include <vector>

#include "engine/physics.h"

namespace mimo::tasks {

// The sum of their squared control inputs.
inline double squared_controls(const engine::Physics& physics, const std::vector<int>& motors) {
  double sum = 0;
  for (const int motor : motors) sum += physics.data().ctrl[motor] * physics.data().ctrl[motor];
  return sum;
}

}  // namespace mimo::tasks
