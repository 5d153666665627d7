// Who feels how much of a touch.
#include <gtest/gtest.h>

#include <cmath>

#include "senses/touch/felt.h"
#include "support/tiny.h"

namespace mimo::senses::touch {
namespace {

constexpr int kBody = 1;
constexpr double kSpacing = 0.01;

Skin skin_of(const std::string& geoms) {
  const auto model = test::compiled("<mujoco><worldbody><body><freejoint/>" + geoms + "</body></worldbody></mujoco>");
  return Skin(*model, {{kBody, kSpacing}});
}

double total(Span<const Share> shares) {
  double sum = 0;
  for (const Share& share : shares) sum += share.weight;
  return sum;
}

const Vec3& place(const Skin& skin, const Share& share) {
  return skin.sensors()[static_cast<std::size_t>(share.sensor)].position;
}

class TouchSpread : public testing::TestWithParam<Response> {};

TEST_P(TouchSpread, SharesAddUpToOneWhereverTheTouchIs) {
  const Skin skin =
      skin_of("<geom type='box' size='.05 .03 .01'/><geom type='capsule' size='.012 .03' pos='.05 0 0'/>");
  Spread spread(skin, GetParam());
  for (int i = 0; i < 1000; ++i) {
    const auto shares = spread.at(kBody, i % 2, 0.1 * Vec3::Random());
    EXPECT_NEAR(total(shares), 1, 1e-12);
    for (const Share& share : shares) EXPECT_GE(share.weight, 0);
  }
}

TEST_P(TouchSpread, NothingReachesBeyondTwoSpacings) {
  const Skin skin = skin_of("<geom type='box' size='.1 .1 .05'/>");
  Spread spread(skin, GetParam());
  for (int i = 0; i < 100; ++i) {
    Vec3 point = 0.07 * Vec3::Random();
    point.z() = 0.05;
    for (const Share& share : spread.at(kBody, 0, point)) {
      EXPECT_LT((place(skin, share) - point).norm(), 2 * kSpacing + 1e-6);
    }
  }
}

TEST_P(TouchSpread, FallsBackToTheNearestSensorOfTheBody) {
  // The first geom has one sensor only, which the touch misses by far; the second has a nearer one.
  const Skin skin = skin_of("<geom size='.004'/><geom type='box' size='.02 .02 .02' pos='.1 0 0'/>");
  Spread spread(skin, GetParam());
  const auto shares = spread.at(kBody, 0, {0.07, 0, 0});
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(skin.sensors()[static_cast<std::size_t>(shares[0].sensor)].geom, 1);
  EXPECT_EQ(shares[0].weight, 1);
}

TEST_P(TouchSpread, TheOtherSideOfAThinPartFeelsNothing) {
  const Skin skin = skin_of("<geom type='box' size='.05 .05 .002'/>");
  Spread spread(skin, GetParam());
  for (int i = 0; i < 100; ++i) {
    Vec3 point = 0.029 * Vec3::Random();  // more than two spacings from the edges
    point.z() = i % 2 == 0 ? 0.002 : -0.002;
    for (const Share& share : spread.at(kBody, 0, point)) EXPECT_EQ(place(skin, share).z(), point.z());
  }
}

TEST_P(TouchSpread, ABuriedGeomPassesItsTouchToTheBody) {
  const Skin skin = skin_of("<geom size='.002'/><geom type='box' size='.02 .02 .02'/>");
  Spread spread(skin, GetParam());
  EXPECT_NEAR(total(spread.at(kBody, 0, {0, 0, 0.02})), 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Responses, TouchSpread,
                         testing::Values(Response::kNearest, Response::kLinear, Response::kGaussian));

// On a flat face, distances along the skin are plain ones.
template <typename Weight>
void expect_weights(Response response, Weight&& weight) {
  const Skin skin = skin_of("<geom type='box' size='.1 .1 .05'/>");
  Spread spread(skin, response);
  const Vec3 point(0.013, -0.0244, 0.05);
  const auto shares = spread.at(kBody, 0, point);
  ASSERT_GT(shares.size(), 8u);
  double sum = 0;
  for (const Share& share : shares) sum += weight((place(skin, share) - point).norm() / kSpacing);
  for (const Share& share : shares) {
    EXPECT_NEAR(share.weight, weight((place(skin, share) - point).norm() / kSpacing) / sum, 1e-6);
  }
}

TEST(TouchSpread, LinearFallsToZeroAtTwiceTheSpacing) {
  expect_weights(Response::kLinear, [](double d) { return 1 - d / 2; });
}

TEST(TouchSpread, GaussianHasADeviationOfTwoThirds) {
  expect_weights(Response::kGaussian, [](double d) { return std::exp(-0.5 * d * d / (4.0 / 9)); });
}

TEST(TouchSpread, NearestIsTheNearest) {
  const Skin skin = skin_of("<geom type='box' size='.1 .1 .05'/>");
  Spread spread(skin, Response::kNearest);
  const Vec3 point(0.013, -0.0244, 0.05);
  const auto shares = spread.at(kBody, 0, point);
  ASSERT_EQ(shares.size(), 1u);
  for (const Sensor& sensor : skin.sensors()) {
    EXPECT_LE((place(skin, shares[0]) - point).norm(), (sensor.position - point).norm());
  }
}

}  // namespace
}  // namespace mimo::senses::touch
