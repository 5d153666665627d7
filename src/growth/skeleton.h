// An infant's body in numbers, as documents hold it: what growth changes. Its parts are found by name.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mimo::growth {

using Vector = std::array<double, 3>;

enum class GeomShape { kSphere, kCapsule, kCylinder, kBox };

struct Geom {
  std::string name;  // without the agent's prefix, as all names here
  GeomShape shape = GeomShape::kSphere;
  Vector size{};  // m, as MuJoCo's: radius; radius and half length; three half lengths
  Vector position{};
  std::array<double, 4> orientation{1, 0, 0, 0};  // w x y z
  double mass = 0;
};

struct Joint {
  std::string name;
  Vector axis{0, 0, 1};
  Vector position{};
  std::array<double, 2> range{};  // rad
  double springref = 0;           // rad
  double stiffness = 0;           // N m / rad
  double damping = 0;             // N m s / rad
  double frictionloss = 0;        // N m
  double armature = 0;            // kg m^2
};

// A site or a camera.
struct Mark {
  std::string name;
  Vector position{};
};

// A body, with what is fixed to it. Positions are in its frame, its own in its parent's.
struct Bone {
  std::string name;
  int parent = -1;  // an earlier bone; -1: the root
  Vector position{};
  std::array<double, 4> orientation{1, 0, 0, 0};  // w x y z
  std::vector<Geom> geoms;
  std::vector<Joint> joints;  // hinges
  std::vector<Mark> marks;
};

struct Motor {
  std::string name;
  std::string joint;
  double gear = 1;                 // N m
  std::array<double, 3> muscle{};  // largest velocity, peak force to the negative and to the positive side
};

struct Skeleton {
  std::vector<Bone> bones;
  std::vector<Motor> motors;
};

// A skeleton's parts by name.

// Names without what says which side they are on: "left_hand" is a "hand".
std::string_view without_side(std::string_view name);
// The same without "robot:" or "act:" before it.
std::string_view plain_name(std::string_view name);
// "left_", "right_" or "": which side a bone, joint or motor is on.
std::string side_of(std::string_view name);

class Parts {
 public:
  explicit Parts(Skeleton& skeleton) : skeleton_(&skeleton) {}

  // Throw Status::kUnsupported where there is none: it is not a built-in body.
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

// Which part of the infant a bone belongs to: what shares one set of factors.

enum class Segment { kTrunk, kHead, kUpperArm, kForearm, kHand, kThigh, kShank, kFoot };

// Throws Status::kUnsupported for a body that is not built in.
Segment segment_of(std::string_view bone);

// Arms and legs, except hands and feet: bones that are as long as a capsule without its round ends.
bool is_limb(Segment segment);

}  // namespace mimo::growth
