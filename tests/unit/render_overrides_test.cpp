// What differs from world to world is seen in the pictures of that world only, with both renderers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "render/renderer.h"
#include "support/access.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

constexpr int kPixels = 64;

// A white ball of 20 cm before a dark wall, from a metre away; 45 degrees over 64 pixels. The one light shines from
// where one looks, and casts no shadow.
engine::ModelPtr stage() {
  static const engine::ModelPtr model = compiled(
      "<mujoco><visual><headlight active='0'/></visual><worldbody><light name='lamp' pos='0 -2 0' dir='0 1 0' "
      "castshadow='false' diffuse='.6 .6 .6' specular='0 0 0' ambient='.2 .2 .2'/>"
      "<body name='ball'><geom name='ball' type='sphere' size='.1' rgba='1 1 1 1'/></body>"
      "<geom name='wall' type='box' size='3 .1 3' pos='0 2 0' rgba='.1 .1 .1 1'/></worldbody></mujoco>");
  return model;
}

env::EnvOptions drawn_by(const std::string& renderer) {
  env::EnvOptions options;
  options.renderer = env::renderer_from(renderer);
  return options;
}

struct Seen {
  std::vector<std::uint8_t> rgb = std::vector<std::uint8_t>(3 * kPixels * kPixels);
  std::vector<std::int32_t> ids = std::vector<std::int32_t>(kPixels * kPixels);

  // Of a pixel half-way up: so many to the right of the middle, or to its left.
  const std::uint8_t* right(int by) const { return &rgb[3 * (kPixels * kPixels / 2 + kPixels / 2 + by)]; }
  const std::uint8_t* left(int by) const { return right(-1 - by); }
  const std::uint8_t* color() const { return right(0); }
  int pixels_of(int geom) const { return static_cast<int>(std::count(ids.begin(), ids.end(), geom)); }
};

Seen look(env::World& world) {
  Seen seen;
  render::Viewpoint from;
  from.distance = 1;
  from.azimuth = 90;
  from.fovy = 45;
  render::Picture picture{kPixels, kPixels, seen.rgb.data()};
  picture.segmentation = seen.ids.data();
  world.draw(from, picture);
  return seen;
}

class Overridden : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    try {
      env::make_renderer(stage(), drawn_by(GetParam()), {});
    } catch (const Error& error) {
      if (error.status() != Status::kUnsupported) throw;
      GTEST_SKIP() << error.message();
    }
    world_ = std::make_unique<env::World>(stage(), std::vector<env::AgentOptions>{}, drawn_by(GetParam()));
    other_ = std::make_unique<env::World>(stage(), std::vector<env::AgentOptions>{}, drawn_by(GetParam()));
    before_ = look(*world_);
    ball_ = id_of(*world_, MIMO_GEOM, "ball");
  }
  void TearDown() override {
    if (other_ == nullptr) return;
    EXPECT_EQ(look(*other_).rgb, before_.rgb) << "another world's picture";
  }

  std::unique_ptr<env::World> world_, other_;
  Seen before_;
  std::int32_t ball_ = -1;
};

TEST_P(Overridden, Colour) {
  EXPECT_EQ(before_.color()[0], before_.color()[1]) << "white";
  set(*world_, MIMO_GEOM_COLOR, {ball_}, {1, 0, 0.5, 1});
  const Seen seen = look(*world_);
  EXPECT_EQ(seen.color()[0], before_.color()[0]);
  EXPECT_EQ(seen.color()[1], 0);
  EXPECT_NEAR(seen.color()[2], before_.color()[2] / 2.0, 2);
}

// Seen from one metre, a ball of radius r covers sin(a) = r: half again as large, 1.5^2 times as many pixels, and a
// little more for being nearer.
TEST_P(Overridden, Size) {
  set(*world_, MIMO_GEOM_SIZE, {ball_}, {0.15, 0, 0});
  const double sine[] = {0.1, 0.15};
  const auto area = [&](double s) { return s * s / (1 - s * s); };
  const double ratio = static_cast<double>(look(*world_).pixels_of(ball_)) / before_.pixels_of(ball_);
  EXPECT_NEAR(ratio, area(sine[1]) / area(sine[0]), 0.1);
}

// A step of 10 cm to the right at one metre is 0.1 / (2 tan 22.5 degrees) of the picture's width.
TEST_P(Overridden, PlaceOfAFixedObject) {
  set(*world_, MIMO_BODY_POSITION, {id_of(*world_, MIMO_BODY, "ball")}, {0.1, 0, 0});
  const Seen seen = look(*world_);
  const double shift = 0.1 / (2 * std::tan(mjPI / 8)) * kPixels;
  double moved = 0, was = 0;
  for (int i = 0; i < kPixels * kPixels; ++i) {
    moved += seen.ids[i] == ball_ ? i % kPixels : 0;
    was += before_.ids[i] == ball_ ? i % kPixels : 0;
  }
  EXPECT_NEAR(moved / seen.pixels_of(ball_) - was / before_.pixels_of(ball_), shift, 0.3);
}

TEST_P(Overridden, LightsColour) {
  set(*world_, MIMO_LIGHT_COLOR, {0}, {0, 0.6, 0});
  const Seen seen = look(*world_);
  EXPECT_EQ(seen.color()[1], before_.color()[1]);
  EXPECT_NEAR(seen.color()[0], before_.color()[0] * 0.2 / 0.8, 4) << "ambient light alone";
}

TEST_P(Overridden, LightsPlaceAndDirection) {
  EXPECT_NEAR(before_.right(5)[0], before_.left(5)[0], 2) << "lit from where one looks";
  set(*world_, MIMO_LIGHT_POSITION, {0}, {2, 0, 0});
  set(*world_, MIMO_LIGHT_DIRECTION, {0}, {-1, 0, 0});
  const Seen seen = look(*world_);
  EXPECT_GT(seen.right(5)[0], seen.left(5)[0] + 40) << "lit from the right";
}

INSTANTIATE_TEST_SUITE_P(Render, Overridden, ::testing::Values("ray", "osmesa"));

}  // namespace
}  // namespace mimo::test
