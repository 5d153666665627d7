// What of hearing is wanted.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mimo::senses {

struct HearingOptions {
  std::uint32_t wanted = 0;  // MIMO_HEARING_ bits
};

// From where and in which direction a body plays, in its frame.
struct Direction {
  std::string body;
  Eigen::Vector3d place, axis;
  double directivity = 0;  // 0 to all sides alike, 0.5 a cardioid, 1 a figure of eight
};

// How much of what hosts play is remembered, and how bodies play that do not do so from their middle to all sides.
struct PlayOptions {
  std::size_t sources = 4;              // bodies that play at once
  double seconds = 4;                   // of what waits at one of them
  std::vector<Direction> directions{};  // later ones count more
};

}  // namespace mimo::senses
