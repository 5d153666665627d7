// Positions and orientations.
#pragma once

#include <array>
#include <pugixml.hpp>

namespace mimo::document {

using Quaternion = std::array<double, 4>;  // w x y z

struct Pose {
  std::array<double, 3> position{};
  Quaternion orientation{1, 0, 0, 0};
};

// Which point of an infant, as it starts, lies at its place.
enum class Anchor : int {
  kRoot = 1,    // the origin of its root body
  kSoles = 2,   // between its feet, at the height of the lowest point of them
  kLowest = 3,  // below its root body, at the height of its lowest point
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
