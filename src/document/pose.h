// Positions and orientations.
#pragma once

#include <array>
#include <cstdint>
#include <pugixml.hpp>

#include "mimo/agent.h"

namespace mimo::document {

using Quaternion = std::array<double, 4>;  // w x y z

struct Pose {
  std::array<double, 3> position{};
  Quaternion orientation{1, 0, 0, 0};
};

// Which point of an infant, as it starts, lies at its place.
enum class Anchor : std::int32_t {
  kRoot = MIMO_PLACE_ROOT,      // the origin of its root body
  kSoles = MIMO_PLACE_SOLES,    // between its feet, at the height of the lowest point of them
  kLowest = MIMO_PLACE_LOWEST,  // below its root body, at the height of its lowest point
};

struct Place {
  Pose pose;
  Anchor anchor = Anchor::kRoot;
};

// The turn `b`, then the turn `a`.
Quaternion product(const Quaternion& a, const Quaternion& b);

// A pose as it is seen from another; the orientations have length 1.
Pose seen_from(const Pose& from, const Pose& pose);

// Puts a body somewhere else in its parent's frame.
void set_pose(pugi::xml_node body, const Pose& pose);

}  // namespace mimo::document
