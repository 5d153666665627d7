// Sensor points on each kind of geom: their number by the original's formulas, their places and normals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

#include "senses/touch/surface.h"

namespace mimo::senses::touch {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kAccuracy = 1e-12;

using Form = OuterShape::Form;

// The counts of the original, written out anew: not in terms of the code under test.
int box_count(const Vec3& half, double spacing) {
  if (0.75 * spacing > half.maxCoeff()) return 1;
  int all = 1, inner = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int n = std::max(2, static_cast<int>(std::ceil(2 * half[axis] / spacing)));
    all *= n;
    inner *= n - 2;
  }
  return all - inner;
}

int sphere_count(double radius, double spacing) {
  if (spacing > radius) return 1;
  const int rings = static_cast<int>(std::ceil(kPi * radius / spacing));
  int count = 0;
  for (int i = 0; i < rings; ++i) {
    count += static_cast<int>(std::nearbyint(2 * kPi * radius * std::sin((i + 0.5) * kPi / rings) / spacing));
  }
  return count;
}

int capsule_count(double radius, double half_length, double spacing) {
  const int around = static_cast<int>(std::ceil(2 * kPi * radius / spacing));
  if (around < 3) return 1;
  const int rings = static_cast<int>(std::ceil(kPi * radius / (2 * spacing)));
  int cap = 1;  // the pole
  for (int i = 1; i < rings; ++i) {
    const int n = static_cast<int>(std::ceil(2 * kPi * radius * std::sin(i * kPi / (2 * rings)) / spacing));
    cap += n < 2 ? 0 : n;
  }
  return 2 * cap + around * (static_cast<int>(std::ceil(2 * half_length / spacing)) + 1);
}

int cylinder_count(double radius, double half_length, double spacing) {
  const int around = static_cast<int>(std::ceil(2 * kPi * radius / spacing));
  const int along = static_cast<int>(std::ceil(2 * half_length / spacing));
  const int radii = static_cast<int>(std::nearbyint(radius / spacing)) + 1;
  if (around < 3 || along < 2 || radii == 1) return 1;
  int cap = 1;
  for (int i = 1; i < radii - 1; ++i) {
    cap += static_cast<int>(std::ceil(2 * kPi * radius * i / (radii - 1) / spacing));
  }
  return 2 * cap + around * (along + 1);
}

int formula(const OuterShape& shape, double spacing) {
  const Vec3& s = shape.size;
  switch (shape.form) {
    case Form::kBox: return box_count(s, spacing);
    case Form::kSphere: return sphere_count(s.x(), spacing);
    case Form::kEllipsoid: return sphere_count(s.maxCoeff(), spacing);
    case Form::kCapsule: return capsule_count(s.x(), s.y(), spacing);
    case Form::kCylinder: return cylinder_count(s.x(), s.y(), spacing);
    case Form::kMesh:  // touch_maps_test.cpp
    case Form::kNone: break;
  }
  return 0;
}

// How far a point is from the surface.
double off_surface(const OuterShape& shape, const Vec3& p) {
  const Vec3& s = shape.size;
  const double radial = std::hypot(p.x(), p.y());
  switch (shape.form) {
    case Form::kBox: return std::abs((p.cwiseAbs() - s).maxCoeff());
    case Form::kSphere: return std::abs(p.norm() - s.x());
    case Form::kEllipsoid: return std::abs(p.cwiseQuotient(s).norm() - 1) * s.minCoeff();
    case Form::kCapsule: return std::abs(std::hypot(radial, std::max(0.0, std::abs(p.z()) - s.y())) - s.x());
    case Form::kCylinder: return std::abs(std::max(radial - s.x(), std::abs(p.z()) - s.y()));
    case Form::kMesh:  // touch_maps_test.cpp
    case Form::kNone: break;
  }
  return 1;
}

struct Case {
  const char* name;
  OuterShape shape;
  double spacing;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name << " at " << c.spacing; }

class SurfacePoints : public testing::TestWithParam<Case> {
 protected:
  const OuterShape& shape() const { return GetParam().shape; }
  double spacing() const { return GetParam().spacing; }
  const Surface surface_ = sample(GetParam().shape, GetParam().spacing);
};

TEST_P(SurfacePoints, AreAsManyAsTheFormulaSays) {
  EXPECT_EQ(static_cast<int>(surface_.points.size()), formula(shape(), spacing()));
}

TEST_P(SurfacePoints, LieOnTheSurface) {
  if (surface_.single()) {
    EXPECT_EQ(surface_.points[0].position, Vec3::Zero());
    return;
  }
  for (const SurfacePoint& point : surface_.points) EXPECT_LT(off_surface(shape(), point.position), kAccuracy);
}

TEST_P(SurfacePoints, NormalsPointOutwards) {
  if (surface_.single()) return;
  for (const SurfacePoint& point : surface_.points) {
    EXPECT_NEAR(point.normal.norm(), 1, kAccuracy);
    const double step = 1e-6;
    EXPECT_FALSE(inside(shape(), point.position + step * point.normal));
    EXPECT_TRUE(inside(shape(), point.position - step * point.normal));
  }
}

TEST_P(SurfacePoints, AreAllDifferent) {
  for (std::size_t i = 0; i < surface_.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((surface_.points[i].position - surface_.points[j].position).norm(), 0.05 * spacing()) << i << " " << j;
    }
  }
}

// No spot of the surface is far from a point: neighbours along an edge are about the spacing apart, and all hang
// together.
TEST_P(SurfacePoints, NeighboursAreNearAndConnected) {
  if (surface_.single()) return;
  std::vector<int> group(surface_.points.size());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&](int i) {
    while (group[static_cast<std::size_t>(i)] != i) i = group[static_cast<std::size_t>(i)];
    return i;
  };
  for (const auto& [a, b] : surface_.edges) {
    const double distance =
        (surface_.points[static_cast<std::size_t>(a)].position - surface_.points[static_cast<std::size_t>(b)].position)
            .norm();
    EXPECT_LT(distance, 2.9 * spacing());  // the diagonal of a box face two spacings wide
    group[static_cast<std::size_t>(root(a))] = root(b);
  }
  for (std::size_t i = 1; i < group.size(); ++i) EXPECT_EQ(root(static_cast<int>(i)), root(0));
}

// The geoms of the mitten body, and some that are harder: exact multiples, needles, flat ones, ones that become a
// point.
const Case kCases[] = {
    {"palm", {Form::kBox, {0.0281, 0.01, 0.0208}}, 0.007},
    {"fingers", {Form::kBox, {0.0228, 0.01, 0.0207}}, 0.002},
    {"fingers", {Form::kBox, {0.0228, 0.01, 0.0207}}, 0.008},
    {"sole", {Form::kBox, {0.035, 0.025, 0.01}}, 0.015},
    {"sole", {Form::kBox, {0.035, 0.025, 0.01}}, 0.06},
    {"cube", {Form::kBox, {0.01, 0.01, 0.01}}, 0.01},
    {"plate", {Form::kBox, {0.1, 0.1, 0.001}}, 0.02},
    {"head", {Form::kSphere, {0.0735, 0, 0}}, 0.013},
    {"head", {Form::kSphere, {0.0735, 0, 0}}, 0.0735},
    {"eye", {Form::kSphere, {0.01125, 0, 0}}, 1.0},
    {"egg", {Form::kEllipsoid, {0.03, 0.05, 0.04}}, 0.008},
    {"egg", {Form::kEllipsoid, {0.03, 0.05, 0.04}}, 0.06},
    {"hip", {Form::kCapsule, {0.048, 0.043, 0}}, 0.025},
    {"upper leg", {Form::kCapsule, {0.037, 0.0625, 0}}, 0.027},
    {"lower leg", {Form::kCapsule, {0.029, 0.044, 0}}, 0.019},
    {"three around", {Form::kCapsule, {0.01, 0.02, 0}}, 0.025},
    {"too thin", {Form::kCapsule, {0.021, 0.028, 0}}, 0.152},
    {"heel", {Form::kCylinder, {0.0249, 0.0099, 0}}, 0.015},
    {"toe tips", {Form::kCylinder, {0.01, 0.025, 0}}, 0.010},
    {"fingertips", {Form::kCylinder, {0.0102, 0.023, 0}}, 0.002},
    {"coin", {Form::kCylinder, {0.03, 0.001, 0}}, 0.01},
};
INSTANTIATE_TEST_SUITE_P(Geoms, SurfacePoints, testing::ValuesIn(kCases));

TEST(Inside, APointOnTheSurfaceIsOutside) {
  EXPECT_FALSE(inside({Form::kSphere, {1, 0, 0}}, {1, 0, 0}));
  EXPECT_FALSE(inside({Form::kSphere, {1, 0, 0}}, {1 - 0.5e-9, 0, 0}));
  EXPECT_TRUE(inside({Form::kSphere, {1, 0, 0}}, {1 - 2e-9, 0, 0}));
}

TEST(Inside, FollowsEachShape) {
  EXPECT_TRUE(inside({Form::kBox, {1, 2, 3}}, {0.99, -1.99, 2.99}));
  EXPECT_FALSE(inside({Form::kBox, {1, 2, 3}}, {0.99, -2.01, 0}));
  EXPECT_TRUE(inside({Form::kCapsule, {1, 2, 0}}, {0, 0.5, 2.8}));
  EXPECT_FALSE(inside({Form::kCapsule, {1, 2, 0}}, {0, 0.7, 2.8}));
  EXPECT_TRUE(inside({Form::kCylinder, {1, 2, 0}}, {0, 0.9, 1.9}));
  EXPECT_FALSE(inside({Form::kCylinder, {1, 2, 0}}, {0.8, 0.8, 0}));
  EXPECT_FALSE(inside({Form::kCylinder, {1, 2, 0}}, {0, 0.9, 2.1}));
  EXPECT_TRUE(inside({Form::kEllipsoid, {1, 2, 3}}, {0, 0, 2.99}));
  EXPECT_TRUE(inside({Form::kEllipsoid, {1, 2, 3}}, {0, 0, 0}));
  EXPECT_FALSE(inside({Form::kEllipsoid, {1, 2, 3}}, {0.8, 1.6, 0}));
  EXPECT_FALSE(inside({}, {0, 0, 0}));
}

}  // namespace
}  // namespace mimo::senses::touch
