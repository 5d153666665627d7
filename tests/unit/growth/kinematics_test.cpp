// Poses, lowest points and loads of bodies that one can calculate by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "base/fail.h"
#include "base/numbers.h"
#include "growth/mechanics.h"

namespace mimo::test {
namespace {

using growth::Geom;
using growth::GeomShape;
using growth::Skeleton;

constexpr double kExact = 1e-14;

// A pole of 1 m, that can tip over its foot at z = 0.2, and in its upper end a weight of 2 kg.
Skeleton pole(const Geom& weight) {
  Skeleton skeleton;
  growth::Bone root, pole;
  root.name = "root";
  pole.name = "pole";
  pole.parent = 0;
  pole.position = {0, 0, 0.5};
  growth::Joint tip;
  tip.name = "tip";
  tip.axis = {0, 2, 0};  // of no particular length
  tip.position = {0, 0, -0.3};
  pole.joints = {tip};
  pole.geoms = {weight};
  pole.geoms[0].position = {0, 0, 0.7};
  skeleton.bones = {root, pole};
  return skeleton;
}

Geom geom(GeomShape shape, const growth::Vector& size) {
  Geom geom;
  geom.shape = shape;
  geom.size = size;
  geom.mass = 2;
  return geom;
}

TEST(GrowthKinematics, FindsTheLowestPointOfEveryShapeInAnyPose) {
  const Geom sphere = geom(GeomShape::kSphere, {0.1, 0, 0});
  EXPECT_NEAR(lowest_point(pole(sphere), {}), 1.2 - 0.1, kExact);
  EXPECT_NEAR(lowest_point(pole(sphere), {{"tip", kPi / 2}}), 0.2 - 0.1, kExact);
  EXPECT_NEAR(lowest_point(pole(sphere), {{"tip", kPi / 3}}), 0.2 + 0.5 - 0.1, kExact);
  const Geom capsule = geom(GeomShape::kCapsule, {0.1, 0.3, 0});
  EXPECT_NEAR(lowest_point(pole(capsule), {}), 1.2 - 0.4, kExact);
  EXPECT_NEAR(lowest_point(pole(capsule), {{"tip", kPi / 3}}), 0.7 - 0.1 - 0.15, kExact);
  const Geom cylinder = geom(GeomShape::kCylinder, {0.1, 0.3, 0});
  EXPECT_NEAR(lowest_point(pole(cylinder), {{"tip", kPi / 2}}), 0.2 - 0.1, kExact);
  EXPECT_NEAR(lowest_point(pole(cylinder), {{"tip", kPi / 3}}), 0.7 - 0.15 - 0.1 * std::sqrt(0.75), kExact);
  const Geom box = geom(GeomShape::kBox, {0.1, 0.2, 0.3});
  EXPECT_NEAR(lowest_point(pole(box), {{"tip", kPi / 2}}), 0.2 - 0.1, kExact);
  EXPECT_NEAR(lowest_point(pole(box), {{"tip", kPi / 3}}), 0.7 - 0.15 - 0.1 * std::sqrt(0.75), kExact);
  EXPECT_NEAR(highest_point(pole(box), {}), 1.5, kExact);
}

TEST(GrowthKinematics, TakesTheFirstBoneAsItStands) {
  Skeleton body = pole(geom(GeomShape::kSphere, {0.1, 0, 0}));
  body.bones[0].position = {1, 2, 3};
  EXPECT_NEAR(lowest_point(body, {}), 3 + 1.1, kExact);
  EXPECT_NEAR(growth::stature(body), 0.2, kExact);
}

TEST(GrowthKinematics, RefusesAnglesOfMissingJoints) {
  try {
    lowest_point(pole(geom(GeomShape::kSphere, {0.1, 0, 0})), {{"tip", 1}, {"tap", 1}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kInvalidArgument);
  }
}

// 2 kg at 1 m from the joint.
TEST(GrowthLoad, IsMomentAndInertiaAboutTheJoint) {
  const growth::Load load = growth::loads(pole(geom(GeomShape::kSphere, {0.1, 0, 0}))).at("tip");
  EXPECT_NEAR(load.moment, 2 * 1, kExact);
  EXPECT_NEAR(load.inertia, 2 * (1 + 0.4 * 0.01), kExact);
}

TEST(GrowthLoad, UsesTheRadiusOfGyrationAboutTheCentre) {
  Skeleton body = pole(geom(GeomShape::kSphere, {0.1, 0, 0}));
  body.bones[1].geoms[0].position = body.bones[1].joints[0].position;
  const growth::Load load = growth::loads(body).at("tip");
  EXPECT_NEAR(load.inertia, 2 * 0.4 * 0.01, kExact);
  EXPECT_NEAR(load.moment, 2 * 0.1 * std::sqrt(0.4), kExact);
}

// From textbooks. Of a capsule: as the sum of thin discs of density rho = m / V, by the midpoint rule.
TEST(GrowthSolids, HaveTheInertiaOfTextbooks) {
  const Eigen::Vector3d box = growth::inertia(geom(GeomShape::kBox, {0.1, 0.2, 0.3}));
  EXPECT_NEAR(box.x(), 2.0 / 3 * (0.04 + 0.09), kExact);
  EXPECT_NEAR(box.z(), 2.0 / 3 * (0.01 + 0.04), kExact);
  const Eigen::Vector3d cylinder = growth::inertia(geom(GeomShape::kCylinder, {0.1, 0.3, 0}));
  EXPECT_NEAR(cylinder.x(), 2 * (0.01 / 4 + 0.09 / 3), kExact);
  EXPECT_NEAR(cylinder.z(), 2 * 0.01 / 2, kExact);

  const Geom capsule = geom(GeomShape::kCapsule, {0.1, 0.3, 0});
  double volume = 0, across = 0, along = 0;
  constexpr int kDiscs = 200000;
  for (int i = 0; i < kDiscs; ++i) {
    const double z = -0.4 + 0.8 * (i + 0.5) / kDiscs, beyond = std::max(0.0, std::abs(z) - 0.3);
    const double square = 0.01 - beyond * beyond, disc = kPi * square * 0.8 / kDiscs;
    volume += disc;
    across += disc * (square / 4 + z * z);
    along += disc * square / 2;
  }
  EXPECT_NEAR(growth::volume(capsule), volume, 1e-9);
  EXPECT_NEAR(growth::inertia(capsule).x(), 2 * across / volume, 1e-9);
  EXPECT_NEAR(growth::inertia(capsule).z(), 2 * along / volume, 1e-9);
}

}  // namespace
}  // namespace mimo::test
