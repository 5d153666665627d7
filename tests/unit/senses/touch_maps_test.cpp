// Distances along the skin.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "senses/touch/skin.h"
#include "support/tiny.h"

namespace mimo::senses::touch {
namespace {

Skin skin_of(const std::string& geoms, double spacing) {
  const auto model = test::compiled("<mujoco><worldbody><body><freejoint/>" + geoms + "</body></worldbody></mujoco>");
  return Skin(*model, {{1, spacing}});
}

// Place of a neighbour on a sensor's map; nothing if it is not on it.
std::optional<double> distance(const Skin& skin, int from, int to) {
  for (const Neighbour& neighbour : skin.maps().of(from)) {
    if (neighbour.sensor == to) return std::hypot(neighbour.x, neighbour.y);
  }
  return std::nullopt;
}

const Sensor& sensor(const Skin& skin, int index) { return skin.sensors()[static_cast<std::size_t>(index)]; }
int count(const Skin& skin) { return static_cast<int>(skin.sensors().size()); }

// Compares all pairs of sensors with the true distance, as far as maps have to reach: two spacings and a bit.
template <typename Truth>
void expect_distances(const Skin& skin, double spacing, double tolerance, Truth&& truth) {
  int compared = 0;
  for (int i = 0; i < count(skin); ++i) {
    for (int j = 0; j < count(skin); ++j) {
      const double expected = truth(sensor(skin, i), sensor(skin, j));
      const auto found = distance(skin, i, j);
      if (expected > 2.7 * spacing) {
        EXPECT_FALSE(found && expected > 3.4 * spacing) << "true distance " << expected / spacing << " spacings";
        continue;
      }
      ASSERT_TRUE(found) << "true distance " << expected / spacing << " spacings";
      EXPECT_NEAR(*found, expected, tolerance * spacing);
      ++compared;
    }
  }
  EXPECT_GT(compared, 5 * count(skin));
}

TEST(TouchMaps, BeginWithTheSensorItselfAndAreSorted) {
  const Skin skin = skin_of("<geom type='box' size='.03 .02 .01'/>", 0.004);
  for (int i = 0; i < count(skin); ++i) {
    const auto map = skin.maps().of(i);
    EXPECT_EQ(map[0].sensor, i);
    double last = 0;
    for (const Neighbour& neighbour : map) {
      const double far = std::hypot(neighbour.x, neighbour.y);
      EXPECT_GE(far, last - 1e-9);
      last = far;
    }
  }
}

// All numbers of all maps.
std::vector<float> numbers_of(const Skin& skin) {
  std::vector<float> numbers;
  for (int i = 0; i < count(skin); ++i) {
    for (const auto& [sensor, x, y] : skin.maps().of(i)) {
      numbers.insert(numbers.end(), {static_cast<float>(sensor), x, y});
    }
  }
  return numbers;
}

constexpr const char* kPlate = "<geom type='box' size='.03 .02 .01'/>";

TEST(TouchMaps, AreThoseOfTheirBodyWhateverWasMadeBefore) {
  const auto first = numbers_of(skin_of(kPlate, 0.004));
  EXPECT_NE(numbers_of(skin_of("<geom type='box' size='.03 .02000001 .01'/>", 0.004)), first);
  EXPECT_EQ(numbers_of(skin_of(kPlate, 0.004)), first);
}

TEST(TouchMaps, ReachAsFarAsIsAskedForWhateverWasMadeBefore) {
  const auto model =
      test::compiled("<mujoco><worldbody><body><freejoint/>" + std::string(kPlate) + "</body></worldbody></mujoco>");
  const BodySensors sensors = place_sensors(*model, 1, 0.004, {});
  Maps far, near;
  far.add(sensors, 0, 0.012);
  near.add(sensors, 0, 0.006);
  EXPECT_LT(near.largest(), far.largest());
  for (const Neighbour& neighbour : near.of(0)) EXPECT_LE(std::hypot(neighbour.x, neighbour.y), 0.006F * 1.00001F);
}

// 8 MB are kept, of the bodies that were made last; a body that has more than that does not push the others out.
TEST(TouchMaps, AreKeptForLaterSkinsUpToALimit) {
  constexpr std::size_t kMost = 8 << 20;
  const auto cube = [](int centimetres, double spacing) {
    const std::string side = std::to_string(centimetres * 0.01) + " ";
    skin_of("<geom type='box' size='" + side + side + side + "'/>", spacing);
  };
  for (int centimetres = 20; centimetres < 30; ++centimetres) cube(centimetres, 0.012);
  const std::size_t full = kept_map_bytes();
  EXPECT_GT(full, kMost / 2);
  EXPECT_LE(full, kMost);
  cube(29, 0.012);
  EXPECT_EQ(kept_map_bytes(), full);
  cube(30, 0.006);
  EXPECT_EQ(kept_map_bytes(), full);
  skin_of(kPlate, 0.0041);
  EXPECT_NE(kept_map_bytes(), full);
}

// The second body's sensors follow those of the first.
TEST(TouchMaps, OfABodyThatWasThereBeforeNameItsSensorsHere) {
  const std::string plate = kPlate;
  const auto model = test::compiled("<mujoco><worldbody><body><freejoint/>" + plate + "</body><body><freejoint/>" +
                                    plate + "</body></worldbody></mujoco>");
  const Skin both(*model, {{1, 0.004}, {2, 0.004}});
  const int half = count(both) / 2;
  for (int i = 0; i < half; ++i) {
    const auto one = both.maps().of(i), other = both.maps().of(half + i);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_EQ(one[k].sensor + half, other[k].sensor);
      EXPECT_EQ(one[k].x, other[k].x);
      EXPECT_EQ(one[k].y, other[k].y);
    }
  }
}

TEST(TouchMaps, FollowGreatCirclesOnASphere) {
  const double radius = 0.0735, spacing = 0.013;
  const Skin skin = skin_of("<geom type='sphere' size='.0735'/>", spacing);
  expect_distances(skin, spacing, 0.1, [&](const Sensor& a, const Sensor& b) {
    return radius * std::acos(std::clamp(a.normal().dot(b.normal()), -1.0, 1.0));
  });
}

TEST(TouchMaps, UnrollACylinder) {
  const double radius = 0.03, spacing = 0.012;
  const Skin skin = skin_of("<geom type='capsule' size='.03 .2'/>", spacing);
  const auto on_side = [](const Sensor& s) {
    return std::abs(s.normal().z()) < 1e-9 && std::abs(s.position.z()) < 0.15;
  };
  for (int i = 0; i < count(skin); ++i) {
    for (int j = 0; j < count(skin); ++j) {
      const Sensor &a = sensor(skin, i), &b = sensor(skin, j);
      if (!on_side(a) || !on_side(b)) continue;
      const double turn = std::acos(std::clamp(a.normal().dot(b.normal()), -1.0, 1.0));
      const double expected = std::hypot(radius * turn, a.position.z() - b.position.z());
      if (expected > 2.7 * spacing) continue;
      ASSERT_TRUE(distance(skin, i, j));
      EXPECT_NEAR(*distance(skin, i, j), expected, 0.02 * spacing);
    }
  }
}

TEST(TouchMaps, FoldABoxOpen) {
  const double spacing = 0.01;
  const Skin skin = skin_of("<geom type='box' size='.05 .05 .05'/>", spacing);
  const double half = 0.05, inner = 0.02;  // far from the other edges
  for (int i = 0; i < count(skin); ++i) {
    for (int j = 0; j < count(skin); ++j) {
      const Vec3 &a = sensor(skin, i).position, &b = sensor(skin, j).position;
      const bool over_edge = a.z() == half && b.x() == half && a.x() < half && b.z() < half &&
                             std::abs(a.y()) < inner && std::abs(b.y()) < inner;
      if (!over_edge) continue;
      const double expected = std::hypot((half - a.x()) + (half - b.z()), a.y() - b.y());
      if (expected > 2.7 * spacing) continue;
      ASSERT_TRUE(distance(skin, i, j));
      EXPECT_NEAR(*distance(skin, i, j), expected, 0.12 * spacing);
    }
  }
}

TEST(TouchMaps, TheOtherSideOfAThinPlateIsFar) {
  const double spacing = 0.01;
  const Skin skin = skin_of("<geom type='box' size='.05 .05 .002'/>", spacing);
  int below_near = 0;
  for (int i = 0; i < count(skin); ++i) {
    const Sensor& top = sensor(skin, i);
    const double to_edge = 0.05 - top.position.head<2>().cwiseAbs().maxCoeff();
    if (top.normal().z() < 0.99) continue;
    for (const Neighbour& neighbour : skin.maps().of(i)) {
      if (sensor(skin, neighbour.sensor).position.z() > 0) continue;
      EXPECT_GT(std::hypot(neighbour.x, neighbour.y), to_edge + 0.003);
      ++below_near;
    }
  }
  EXPECT_GT(below_near, 0);  // around the edge, the skin does go on
}

TEST(TouchMaps, CrossTheSeamOfTwoGeoms) {
  const double spacing = 0.01;
  const Skin skin =
      skin_of("<geom type='capsule' size='.03 .05'/><geom type='capsule' size='.03 .05' pos='0 0 .08'/>", spacing);
  // Coaxial capsules that overlap make one long one.
  int across = 0;
  for (int i = 0; i < count(skin); ++i) {
    for (const Neighbour& neighbour : skin.maps().of(i)) {
      const Sensor &a = sensor(skin, i), &b = sensor(skin, neighbour.sensor);
      if (a.geom == b.geom || std::abs(a.normal().z()) > 1e-9 || std::abs(b.normal().z()) > 1e-9) continue;
      const double turn = std::acos(std::clamp(a.normal().dot(b.normal()), -1.0, 1.0));
      EXPECT_NEAR(std::hypot(neighbour.x, neighbour.y), std::hypot(0.03 * turn, a.position.z() - b.position.z()),
                  0.15 * spacing);
      ++across;
    }
  }
  EXPECT_GT(across, 100);
}

TEST(TouchMaps, LoneSensorsHaveNoNeighbours) {
  const Skin skin = skin_of("<geom type='sphere' size='.01'/><geom type='sphere' size='.01' pos='.015 0 0'/>", 0.02);
  ASSERT_EQ(count(skin), 2);
  EXPECT_EQ(skin.maps().of(0).size(), 1u);
  EXPECT_EQ(skin.maps().of(1).size(), 1u);
}

TEST(TouchSkin, OmitsBuriedPoints) {
  const Skin skin = skin_of("<geom type='sphere' size='.05'/><geom type='box' size='.06 .02 .02'/>", 0.01);
  for (const Sensor& s : skin.sensors()) {
    const OuterShape box{OuterShape::Form::kBox, {0.06, 0.02, 0.02}}, sphere{OuterShape::Form::kSphere, {0.05, 0, 0}};
    EXPECT_FALSE(inside(s.geom == 0 ? box : sphere, s.position));
  }
  // One for each cm^2 of what is not buried: the sphere's 314 less twice the box's end of 16, and of the box two ends
  // of 16 with four sides of 4 x 1.4 (it leaves the sphere at 4.6 on average).
  EXPECT_NEAR(count(skin), 314 - 2 * 16 + 2 * (16 + 4 * 4 * 1.4), 0.1 * 359);
}

TEST(TouchSkin, OmitsPointsInsideOtherGeomsWithoutHidingOthers) {
  const Skin skin = skin_of("<geom type='sphere' size='.05'/><geom type='sphere' size='.005'/>", 0.01);
  for (const Sensor& s : skin.sensors()) EXPECT_EQ(s.geom, 0);
  EXPECT_GT(count(skin), 100);
}

TEST(TouchSkin, FramesAreNormalAndTangents) {
  const Skin skin = skin_of("<geom type='capsule' size='.03 .05' euler='20 30 40'/>", 0.01);
  int switched = 0;
  for (const Sensor& s : skin.sensors()) {
    EXPECT_NEAR(s.frame.determinant(), 1, 1e-9);
    EXPECT_TRUE((s.frame * s.frame.transpose()).isIdentity(1e-9));
    const bool x_is_normal = std::abs(s.normal().x()) > std::cos(10 * 3.14159265358979 / 180);
    const Vec3 axis = x_is_normal ? Vec3::UnitY() : Vec3::UnitX();
    EXPECT_GT(s.frame.row(1).dot(axis), 0);
    EXPECT_NEAR(s.frame.row(2).dot(axis), 0, 1e-9);  // normal x first is perpendicular to both
    switched += x_is_normal;
  }
  EXPECT_GT(switched, 0);
}

// A body whose only geom is a mesh of these points, in the body's own frame.
engine::ModelPtr mesh_of(const std::string& points) {
  return test::compiled(
      "<mujoco><asset><mesh name='m' vertex='" + points +
      "'/></asset><worldbody><body><freejoint/><geom type='mesh' mesh='m'/></body></worldbody></mujoco>");
}

// On an octahedron the coordinates' sizes add up to the same everywhere.
TEST(TouchSkin, AMeshHasItsSensorsOnItsSurface) {
  const auto model = mesh_of(".1 0 0 -.1 0 0 0 .1 0 0 -.1 0 0 0 .1 0 0 -.1");
  const Skin skin(*model, {{1, 0.02}});
  for (const Sensor& s : skin.sensors()) {
    EXPECT_NEAR(s.position.lpNorm<1>(), 0.1, 1e-7);
    EXPECT_TRUE((s.normal() * std::sqrt(3) - s.position.cwiseSign()).isZero(1e-6)) << "outward";
  }
}

// A bar of 30 x 6 x 4 cm: as many sensors as it has squares of the spacing, none too near to another, and none too far
// from any place on it.
TEST(TouchSkin, AMeshesSensorsAreEvenlySpaced) {
  const Vec3 half(.15, .03, .02);
  std::string points;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) points += std::to_string((corner >> axis & 1 ? 1 : -1) * half[axis]) + " ";
  }
  const auto model = mesh_of(points);
  for (const double spacing : {0.01, 0.005}) {
    const Skin skin(*model, {{1, spacing}});
    const double area = 8 * (half.x() * half.y() + half.y() * half.z() + half.z() * half.x());
    const double squares = area / (spacing * spacing);
    EXPECT_NEAR(count(skin), squares, 0.1 * squares) << spacing;
    for (const Sensor& s : skin.sensors()) {
      for (const Sensor& t : skin.sensors()) {
        if (&s != &t) {
          ASSERT_GT((s.position - t.position).norm(), 0.75 * spacing);
        }
      }
    }
    for (int i = 0; i < 2000; ++i) {
      Vec3 place = Vec3::Random().cwiseProduct(half);
      const int face = i % 3;
      place[face] = (i % 2 == 0 ? 1 : -1) * half[face];
      ASSERT_LT((sensor(skin, skin.nearest(0, place)).position - place).norm(), spacing) << place.transpose();
    }
    EXPECT_EQ(Skin(*model, {{1, spacing}}).sensors()[7].position, skin.sensors()[7].position)
        << "the same in every run";
  }
}

// Contacts lie on the hull of a mesh that is not convex, and so do the sensors.
TEST(TouchSkin, AMeshsHollowsAreCovered) {
  const auto model = mesh_of("-.1 0 0  .1 0 0  -.1 .1 0  .1 .1 0  -.1 0 .1  .1 0 .1  -.1 .1 .1  .1 .1 .1  0 .05 .05");
  const Skin skin(*model, {{1, 0.01}});
  for (const Sensor& s : skin.sensors()) {
    const Vec3 from_middle = (s.position - Vec3(0, .05, .05)).cwiseAbs().cwiseQuotient(Vec3(.1, .05, .05));
    EXPECT_NEAR(from_middle.maxCoeff(), 1, 1e-6);
  }
}

TEST(TouchSkin, APartInsideAMeshHasNoSensors) {
  const auto model = test::compiled(
      "<mujoco><asset><mesh name='m' vertex='.1 0 0 -.1 0 0 0 .1 0 0 -.1 0 0 0 .1 0 0 -.1'/></asset><worldbody><body>"
      "<freejoint/><geom type='mesh' mesh='m'/><geom size='.03'/><geom size='.03' pos='.2 0 "
      "0'/></body></worldbody></mujoco>");
  const Skin skin(*model, {{1, 0.01}});
  int inner = 0, outer = 0;
  for (const Sensor& s : skin.sensors()) {
    inner += s.geom == 1;
    outer += s.geom == 2;
  }
  EXPECT_EQ(inner, 0);
  EXPECT_GT(outer, 50);
}

TEST(TouchSkin, HasNoSensorsOnGeomsWithoutContacts) {
  const Skin skin =
      skin_of("<geom size='.05' contype='0' conaffinity='0'/><geom size='.01' pos='.1 0 0' contype='0'/>", 0.005);
  for (const Sensor& s : skin.sensors()) EXPECT_EQ(s.geom, 1);
  EXPECT_GT(count(skin), 0);
}

TEST(TouchSkin, RefusesMoreSensorsThanFit) {
  test::expect_error(Status::kInvalidArgument, "at most 1e+06",
                     [] { skin_of("<geom type='sphere' size='1'/>", 1e-5); });
}

// The nearest sensor, by trying all.
TEST(TouchSkin, FindsTheNearestSensor) {
  const Skin skin =
      skin_of("<geom type='box' size='.03 .02 .01'/><geom type='capsule' size='.01 .03' pos='.03 0 0'/>", 0.005);
  for (int i = 0; i < 500; ++i) {
    const Vec3 place = 0.05 * Vec3::Random();
    for (const int geom : {0, 1}) {
      double nearest = 1;
      for (const Sensor& s : skin.sensors()) {
        if (s.geom == geom) nearest = std::min(nearest, (s.position - place).norm());
      }
      const Sensor& found = sensor(skin, skin.nearest(geom, place));
      EXPECT_EQ(found.geom, geom);
      EXPECT_EQ((found.position - place).norm(), nearest);
    }
  }
}

}  // namespace
}  // namespace mimo::senses::touch
