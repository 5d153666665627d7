#include "geometry/axes.h"

namespace mimo::geometry {
namespace {

// Rows: the engine's x, y and z in ours (x forward, y left, z up).
Eigen::Matrix3d axes_of(Axes axes) {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Identity();
  switch (axes) {
    case Axes::kMimo: break;
    case Axes::kUnity: rows << 0, -1, 0, 0, 0, 1, 1, 0, 0; break;   // right, up, forward
    case Axes::kUnreal: rows << 1, 0, 0, 0, -1, 0, 0, 0, 1; break;  // forward, right, up
    case Axes::kGodot: rows << 0, -1, 0, 0, 0, 1, -1, 0, 0; break;  // right, up, backward
    case Axes::kGltf: rows << 0, 1, 0, 0, 0, 1, 1, 0, 0; break;     // left, up, forward
  }
  return rows;
}

}  // namespace

// In a mirrored frame the same corners turn the other way. Unity and Godot take triangles for outsides whose corners
// turn clockwise as they are seen, the others those that turn counter-clockwise.
Conversion::Conversion(Axes axes)
    : axes_(axes_of(axes)),
      units_(axes == Axes::kUnreal ? 100 : 1),
      flips_(axes == Axes::kUnity || axes == Axes::kGodot),
      scalar_first_(axes == Axes::kMimo) {}

// The axis of a turn is turned like all vectors, and once more where the frame is mirrored.
Eigen::Vector4d Conversion::rotation(const Eigen::Quaterniond& q) const {
  const Eigen::Vector3d axis = axes_.determinant() * (axes_ * q.vec());
  if (scalar_first_) return {q.w(), axis[0], axis[1], axis[2]};
  return {axis[0], axis[1], axis[2], q.w()};
}

}  // namespace mimo::geometry
