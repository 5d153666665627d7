// Where joints lie among the positions and velocities of a world.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mimo/mimo.hpp>
#include <vector>

namespace cli {

// Parts of a pose as tables call them; a ball's are the last four.
constexpr std::array<const char*, 7> kPoseParts = {"x", "y", "z", "qw", "qx", "qy", "qz"};

struct Joint {
  std::int32_t id;
  std::size_t place, width;       // among the positions: 1 of a hinge or slide, 4 of a ball, 7 of a free joint
  std::size_t velocity, freedom;  // among the velocities: 1, 3 or 6

  bool turns() const { return width >= 4; }
  std::size_t linear() const { return turns() ? freedom - 3 : 1; }  // how many numbers are no orientation
  std::size_t quaternion() const { return place + width - 4; }      // of one that turns
};

std::vector<Joint> joints_of(const mimo::Env& env);

}  // namespace cli
