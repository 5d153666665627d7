// The frames of engines, as their manuals describe them: Unity is left-handed, y up, z forward; Unreal left-handed, x
// forward, z up, centimetres; Godot right-handed, y up, -z forward; glTF right-handed, y up, z forward.
#include "geometry/axes.h"

#include <gtest/gtest.h>

namespace mimo::geometry {
namespace {

using Eigen::Vector3d;

struct Frame {
  Axes axes;
  Vector3d forward, left, up;
  bool mirrored;
};

const Frame kFrames[] = {
    {Axes::kMimo, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, false},
    {Axes::kUnity, {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}, true},
    {Axes::kUnreal, {100, 0, 0}, {0, -100, 0}, {0, 0, 100}, true},
    {Axes::kGodot, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}, false},
    {Axes::kGltf, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, false},
};

class EachFrame : public testing::TestWithParam<Frame> {};

TEST_P(EachFrame, LooksForwardLeftAndUp) {
  const Conversion to(GetParam().axes);
  EXPECT_EQ(to.point({1, 0, 0}), GetParam().forward);
  EXPECT_EQ(to.point({0, 1, 0}), GetParam().left);
  EXPECT_EQ(to.point({0, 0, 1}), GetParam().up);
  EXPECT_EQ(to.direction({0, 1, 0}), GetParam().left.normalized());
}

// A point that is turned and then converted is one that is converted and then turned, with the formula that all engines
// have: p + 2 v x (v x p + w p).
TEST_P(EachFrame, TurnsAsBefore) {
  const Conversion to(GetParam().axes);
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.4, -0.5, 0.7, 0.33).normalized();
  const Eigen::Vector4d given = to.rotation(q);
  const bool ours = GetParam().axes == Axes::kMimo;
  const Vector3d v = ours ? given.tail<3>() : given.head<3>();
  const double w = ours ? given[0] : given[3];
  const Vector3d p(0.3, -1.2, 0.8);
  const Vector3d converted = to.point(p);
  const Vector3d turned = converted + 2 * v.cross(v.cross(converted) + w * converted);
  EXPECT_LT((turned - to.point(q * p)).norm(), 1e-13);
}

// Unity and Godot draw triangles whose corners turn clockwise for the viewer, the others those that turn the other way.
// For viewers in a left-handed frame, clockwise is what the cross product of its numbers calls counter-clockwise.
TEST_P(EachFrame, ShowsTheOutsideOfTriangles) {
  const Conversion to(GetParam().axes);
  Vector3d b = to.point({1, 0, 0}) - to.point({0, 0, 0});
  Vector3d c = to.point({0, 1, 0}) - to.point({0, 0, 0});
  if (to.flips()) std::swap(b, c);
  const double along_normal = b.cross(c).dot(to.direction({0, 0, 1}));
  const bool clockwise = GetParam().mirrored ? along_normal > 0 : along_normal < 0;
  EXPECT_EQ(clockwise, GetParam().axes == Axes::kUnity || GetParam().axes == Axes::kGodot);
}

INSTANTIATE_TEST_SUITE_P(Axes, EachFrame, testing::ValuesIn(kFrames));

}  // namespace
}  // namespace mimo::geometry
