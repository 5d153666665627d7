// The skin of infants of other ages: the same sensors, on a larger or smaller body.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "base/format.h"
#include "senses/touch/felt.h"
#include "senses/touch/touch.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using senses::touch::BornGeoms;
using senses::touch::Sensor;
using senses::touch::Skin;
using senses::touch::Vec3;

engine::ModelPtr infant(const std::string& body, double age, bool keep_spacing = false) {
  scene::Scene scene(named("free"));
  scene.add_body(body, "", nullptr);
  growth::Growth growth;
  growth.age = growth.physiological_age = age;
  growth.keep_spacing = keep_spacing;
  scene.grow("", growth);
  return compile(scene);
}

Skin skin_of(const mjModel& model, double scale = 1) {
  const body::Body body = body::find_body(model, "");
  senses::TouchOptions options;
  options.scale = scale;
  return Skin(model, senses::spacings(model, body, options), BornGeoms(model, body));
}

int body_id(const mjModel& model, const std::string& name) { return engine::find_or_fail(model, Kind::kBody, name); }

Vec3 in_geom(const mjModel& model, const Sensor& sensor) {
  const double* q = model.geom_quat + 4 * sensor.geom;
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).conjugate() *
         (sensor.position - Vec3(model.geom_pos + 3 * sensor.geom));
}

// How far a point is from a geom's surface, by the shapes' definitions; 0 for the middle, where small geoms have their
// only sensor.
double off_surface(const mjModel& model, const Sensor& sensor) {
  const Vec3 p = in_geom(model, sensor);
  const double* size = model.geom_size + 3 * sensor.geom;
  const double beyond = std::max(std::abs(p.z()) - size[1], 0.0);
  switch (model.geom_type[sensor.geom]) {
    case mjGEOM_SPHERE: return std::min(p.norm(), std::abs(p.norm() - size[0]));
    case mjGEOM_CAPSULE: return std::min(p.norm(), std::abs(std::hypot(p.x(), p.y(), beyond) - size[0]));
    case mjGEOM_CYLINDER:
      return std::min(p.norm(), std::abs(std::max(std::hypot(p.x(), p.y()) - size[0], std::abs(p.z()) - size[1])));
    case mjGEOM_BOX: return std::min(p.norm(), std::abs((p.cwiseAbs() - Vec3(size)).maxCoeff()));
    default: return 1;
  }
}

class TouchGrowth : public testing::TestWithParam<std::tuple<const char*, double>> {};

TEST_P(TouchGrowth, KeepsItsSensorsOnTheSkin) {
  const auto [body, age] = GetParam();
  const engine::ModelPtr born = infant(body, 18), grown = infant(body, age);
  for (const double scale : {0.5, 1.0}) {
    const Skin was = skin_of(*born, scale), is = skin_of(*grown, scale);
    ASSERT_EQ(is.sensors().size(), was.sensors().size());
    for (std::size_t i = 0; i < is.sensors().size(); ++i) {
      const Sensor& sensor = is.sensors()[i];
      EXPECT_EQ(sensor.geom, was.sensors()[i].geom);
      EXPECT_EQ(sensor.frame, was.sensors()[i].frame) << "growth turns nothing";
      EXPECT_NEAR(off_surface(*grown, sensor), 0, 1e-9) << engine::name(*grown, Kind::kGeom, sensor.geom);
    }
  }
}

// Sensors of the left side are those of the right one, seen in a mirror, where they are so at 18 months.
TEST_P(TouchGrowth, IsTheSameOnBothSides) {
  const auto [body, age] = GetParam();
  const engine::ModelPtr born = infant(body, 18), grown = infant(body, age);
  const Skin was = skin_of(*born), is = skin_of(*grown);
  const auto sensors_on = [&](const Skin& skin, const std::string& part) {
    std::vector<Vec3> places;
    for (const Sensor& sensor : skin.sensors()) {
      if (sensor.body == body_id(*born, part)) places.push_back(sensor.position);
    }
    return places;
  };
  const auto mirrored = [](Vec3 place) { return Vec3(place.x(), -place.y(), place.z()); };
  int compared = 0;
  for (const std::string part : {"upper_arm", "lower_arm", "hand", "upper_leg", "lower_leg", "foot", "eye"}) {
    const auto left_was = sensors_on(was, "left_" + part), right_was = sensors_on(was, "right_" + part);
    const auto left = sensors_on(is, "left_" + part), right = sensors_on(is, "right_" + part);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      for (std::size_t j = 0; j < right.size(); ++j) {
        if ((left_was[i] - mirrored(right_was[j])).norm() > 1e-12) continue;
        EXPECT_LT((left[i] - mirrored(right[j])).norm(), 1e-12) << part;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 400);
}

// Sensors are as far apart as the root of the skin's area says: on the head, a sphere, that is its radius.
TEST_P(TouchGrowth, SpacingScalesWithTheSkin) {
  const auto [body, age] = GetParam();
  const engine::ModelPtr born = infant(body, 18), grown = infant(body, age);
  const int head = body_id(*born, "head");
  const double ratio = grown->geom_size[3 * grown->body_geomadr[head]] / born->geom_size[3 * born->body_geomadr[head]];
  EXPECT_NEAR(skin_of(*grown).spacing(head), 0.013 * ratio, 1e-12);
  EXPECT_EQ(skin_of(*born).spacing(head), 0.013);
}

// How many sensors feel a press on the palm, the mean over all of it.
double feel_a_press(const mjModel& model) {
  const Skin skin = skin_of(model);
  senses::touch::Spread spread(skin, senses::touch::Response::kLinear);
  const int hand = body_id(model, "left_hand"), geom = model.body_geomadr[hand];
  const Vec3 half(model.geom_size + 3 * geom);
  constexpr int kPresses = 40;  // along each side
  std::size_t sum = 0;
  for (int i = 0; i < kPresses * kPresses; ++i) {
    const Vec3 share((2 * (i % kPresses) + 1.0) / kPresses - 1, 1, (2.0 * (i / kPresses) + 1) / kPresses - 1);
    sum += spread.at(hand, geom, Vec3(model.geom_pos + 3 * geom) + half.cwiseProduct(share)).size();
  }
  return static_cast<double>(sum) / (kPresses * kPresses);
}

// Spread over distances that were still those of 18 months, a newborn's press would reach far more. The hand does not
// keep its proportions, so that single presses reach a few sensors more or fewer.
TEST_P(TouchGrowth, PressOnThePalmReachesAsManySensors) {
  const auto [body, age] = GetParam();
  const double was = feel_a_press(*infant(body, 18)), is = feel_a_press(*infant(body, age));
  EXPECT_NEAR(is, was, 0.05 * was);
}

INSTANTIATE_TEST_SUITE_P(Ages, TouchGrowth,
                         testing::Combine(testing::Values("mitten", "fingers"), testing::Values(0.0, 3.0, 12.0, 24.0)),
                         [](const auto& test) {
                           return format("{}{:g}", std::get<0>(test.param), std::get<1>(test.param));
                         });

TEST(TouchKeptSpacing, MakesFewerSensorsOnSmallerBodies) {
  const engine::ModelPtr born = infant("mitten", 18), grown = infant("mitten", 3, true);
  const Skin was = skin_of(*born), is = skin_of(*grown);
  EXPECT_LT(is.sensors().size(), was.sensors().size());
  const int head = body_id(*born, "head");
  EXPECT_EQ(is.spacing(head), 0.013);
}

}  // namespace
}  // namespace mimo::test
