// Positions of joints out of poses of bodies: least squares over all joints between those bodies, row after row.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <vector>

#include "motion/movement.h"

namespace cli {

// How far a body is from where it was told to be, because its joints cannot follow.
struct PoseError {
  std::int32_t body;
  double angle_largest = 0, angle_mean = 0;        // rad
  double distance_largest = 0, distance_mean = 0;  // m
};

// Adds tracks of all joints that the bodies' poses say something about and that have none yet. Changes positions and
// velocities of the world. A centimetre counts as much as a tenth of a radian.
std::vector<PoseError> fit_poses(Movement& movement, mimo::Env& env);

}  // namespace cli
