// A skeleton's parts by name.
#pragma once

#include <string>
#include <string_view>

#include "growth/skeleton.h"

namespace mimo::growth {

// Names without what says which side they are on: "left_hand" is a "hand".
std::string_view without_side(std::string_view name);
// The same without "robot:" or "act:" before it.
std::string_view plain_name(std::string_view name);
// "left_", "right_" or "": which side a bone, joint or motor is on.
std::string side_of(std::string_view name);

class Parts {
 public:
  explicit Parts(Skeleton& skeleton) : skeleton_(&skeleton) {}

  // Throw Status::kUnsupported where there is none: the body is none of ours.
  Bone& bone(std::string_view name) const;
  Geom& geom(std::string_view name) const;
  Joint& joint(std::string_view name) const;
  Mark& mark(std::string_view name) const;

  bool has_bone(std::string_view name) const;

 private:
  Skeleton* skeleton_;
};

// The same to look at.
const Bone& bone(const Skeleton& skeleton, std::string_view name);
const Geom& geom(const Skeleton& skeleton, std::string_view name);

double total_mass(const Skeleton& skeleton);  // kg

}  // namespace mimo::growth
