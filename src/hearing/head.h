// A head that hears: a ball with an ear on each side.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "sound/sphere.h"

namespace mimo::hearing {

constexpr std::size_t kEars = 2;  // left, right
using Ways = std::array<sound::Way, kEars>;

// Where a head is, in the world.
struct Head {
  double radius = 0;                        // m
  Eigen::Vector3d middle;                   // of the ball
  std::array<Eigen::Vector3d, kEars> ears;  // from there, of length 1
};

// Of an infant's head that looks along x of its frame, with z up: ears lie 100 degrees to both sides, as in adults.
std::array<Eigen::Vector3d, kEars> ears_of_frame();

Ways ways_to(const Head& head, const Eigen::Vector3d& place);

}  // namespace mimo::hearing
