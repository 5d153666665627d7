// Numbers in attributes, as far as they can be read, and poses. What cannot be read is left to the compiler, which
// reports it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "mimo/agent.h"

namespace mimo::document {

// The first number of an attribute; nothing if it is not there or begins with something else.
std::optional<double> number(pugi::xml_node node, const char* attribute);
// All up to the first that is none.
std::vector<double> numbers_in(pugi::xml_node node, const char* attribute);
// How many words an attribute has.
std::size_t words(pugi::xml_attribute attribute);

// Reads a number out of a text and moves on past it; nothing if there is none.
std::optional<double> take_number(const char*& at, const char* end);

// Positions and orientations.

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
