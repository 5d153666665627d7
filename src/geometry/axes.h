// The frames of engines: which way their axes point, how long their units are, how they write rotations.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mimo/geometry.h"

namespace mimo::geometry {

// Of the header.
enum class Axes : std::int32_t {
  kMimo = MIMO_AXES_MIMO,
  kUnity = MIMO_AXES_UNITY,
  kUnreal = MIMO_AXES_UNREAL,
  kGodot = MIMO_AXES_GODOT,
  kGltf = MIMO_AXES_GLTF,
};

class Conversion {
 public:
  explicit Conversion(Axes axes);

  Eigen::Vector3d point(const Eigen::Vector3d& p) const { return units_ * (axes_ * p); }
  Eigen::Vector3d direction(const Eigen::Vector3d& v) const { return axes_ * v; }
  // Four numbers in the order of that engine: w x y z in MuJoCo, x y z w in the others.
  Eigen::Vector4d rotation(const Eigen::Quaterniond& q) const;
  // Whether the corners of a triangle, counter-clockwise from outside in our frame, have to be given the other way.
  bool flips() const { return flips_; }

 private:
  Eigen::Matrix3d axes_;
  double units_;  // in a metre
  bool flips_;
  bool scalar_first_;
};

}  // namespace mimo::geometry
