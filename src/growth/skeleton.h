// An infant's body in numbers, as documents hold it: what growth changes.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace mimo::growth {

using Vector = std::array<double, 3>;

enum class Shape { kSphere, kCapsule, kCylinder, kBox };

struct Geom {
  std::string name;  // without the agent's prefix, as all names here
  Shape shape = Shape::kSphere;
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

}  // namespace mimo::growth
