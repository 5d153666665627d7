// Joints and actions of a world: where joints lie in its state, and random actions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mimo/mimo.hpp>
#include <random>
#include <vector>

namespace cli {

// Angles are radians; people say degrees.

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

// Where joints lie among the positions and velocities of a world.

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

// Actions drawn uniformly between their bounds, the same everywhere for the same seed.

class RandomActions {
 public:
  RandomActions(const mimo::Env& env, std::uint64_t seed);
  std::vector<float> draw();

 private:
  struct Bounds {
    double low, high;
  };

  std::mt19937_64 generator_;
  std::vector<Bounds> bounds_;
};

}  // namespace cli
