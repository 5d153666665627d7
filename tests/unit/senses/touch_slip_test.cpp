// Slip and friction use, on a slope: a block that slides with a known speed, and one that sticks.
#include <gtest/gtest.h>

#include <cmath>

#include "touch_feeler.h"

namespace mimo::senses::touch {
namespace {

constexpr int kSlab = 1, kBlock = 2;
constexpr double kFriction = 0.5, kGravity = 9.81;

// A slab and a block on it. Not the slab is tilted but gravity, along x.
engine::ModelPtr slope(double angle, const std::string& cone) {
  return test::compiled(fmt::format(
      "<mujoco><option timestep='0.005' cone='{}' gravity='{} 0 {}'/>"
      "<default><geom friction='{}' condim='3' solref='0.005 1' solimp='0.95 0.99 0.001 0.5 1'/></default><worldbody>"
      "<body><geom type='box' size='2 .2 .05' pos='0 0 -.05'/></body>"
      "<body pos='-1.5 0 .03'><freejoint/><geom type='box' size='.04 .04 .03' mass='1'/></body></worldbody></mujoco>",
      cone, kGravity * std::sin(angle), -kGravity * std::cos(angle), kFriction));
}

TouchOptions all_outputs() {
  TouchOptions options;
  options.slip = options.friction_use = true;
  options.frame = TouchFrame::kSkin;
  return options;
}

// The sensors that feel something.
std::vector<std::size_t> pressed(const Feeler& feeler, int body) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < feeler.sensors().size(); ++i) {
    if (feeler.sensors()[i].body == body && !feeler.row("touch/force", i).isZero()) list.push_back(i);
  }
  return list;
}

// A sensor's slip in the frame of its body.
Vec3 slip_of(const Feeler& feeler, std::size_t sensor) {
  const Eigen::VectorXd slip = feeler.row("touch/slip", sensor);
  return feeler.sensors()[sensor].frame.bottomRows<2>().transpose() * slip;
}

class TouchSlip : public testing::TestWithParam<const char*> {};

TEST_P(TouchSlip, IsTheSpeedOfASlidingBlock) {
  const double angle = 0.7;
  Feeler feeler(slope(angle, GetParam()), {{kSlab, 0.05}, {kBlock, 0.01}}, all_outputs());
  feeler.physics.step(100);
  feeler.physics.forward();
  feeler.feel();
  const double speed = feeler.physics.data().qvel[0];
  EXPECT_NEAR(speed, 0.5 * kGravity * (std::sin(angle) - kFriction * std::cos(angle)), 0.02) << "as physics books say";
  for (const std::size_t i : pressed(feeler, kBlock)) {  // the slab slides backwards over the block's skin
    EXPECT_LT((slip_of(feeler, i) - Vec3(-speed, 0, 0)).norm(), 0.02 * speed);
    EXPECT_GT(feeler.row("touch/friction_use", i)[0], 0.98);
  }
  for (const std::size_t i : pressed(feeler, kSlab)) EXPECT_LT((slip_of(feeler, i) - Vec3(speed, 0, 0)).norm(), 0.02 * speed);
  EXPECT_GT(pressed(feeler, kBlock).size(), 4u);
  EXPECT_GT(pressed(feeler, kSlab).size(), 4u);
}

TEST_P(TouchSlip, IsNoneWhereABlockSticks) {
  const double angle = 0.3;
  Feeler feeler(slope(angle, GetParam()), {{kSlab, 0.05}, {kBlock, 0.01}}, all_outputs());
  feeler.physics.step(400);
  feeler.physics.forward();
  feeler.feel();
  const double creep = feeler.physics.data().qvel[0];
  EXPECT_GT(creep, 1e-5) << "MuJoCo's friction creeps";
  EXPECT_LT(creep, 0.5 * all_outputs().slip_threshold);
  double use = 0, force = 0;
  for (const std::size_t i : pressed(feeler, kBlock)) {
    EXPECT_TRUE(feeler.row("touch/slip", i).isZero());
    const double normal = -feeler.row("touch/force", i)[0];
    use += feeler.row("touch/friction_use", i)[0] * normal;
    force += normal;
  }
  EXPECT_NEAR(use / force, std::tan(angle) / kFriction, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Cones, TouchSlip, testing::Values("elliptic", "pyramidal"));

TEST(TouchSlip, CreepIsSeenWithAThresholdOfZero) {
  TouchOptions options = all_outputs();
  options.slip_threshold = 0;
  Feeler feeler(slope(0.3, "elliptic"), {{kBlock, 0.01}}, options);
  feeler.physics.step(400);
  feeler.physics.forward();
  feeler.feel();
  const auto sensors = pressed(feeler, kBlock);
  ASSERT_FALSE(sensors.empty());
  for (const std::size_t i : sensors) EXPECT_GT(slip_of(feeler, i).norm(), 0);
}

TEST(TouchSlip, FrictionlessContactsUseNone) {
  const auto model = test::compiled(
      "<mujoco><option timestep='0.005'/><worldbody><body><geom type='box' size='1 1 .05'/></body><body pos='0 0 .1'>"
      "<freejoint/><geom type='sphere' size='.05' condim='1'/></body></worldbody></mujoco>");
  const_cast<mjModel*>(model.get())->geom_condim[0] = 1;
  Feeler feeler(model, {{kBlock, 0.02}}, all_outputs());
  feeler.physics.step(400);
  feeler.physics.forward();
  feeler.feel();
  const auto sensors = pressed(feeler, kBlock);
  ASSERT_FALSE(sensors.empty());
  for (const std::size_t i : sensors) EXPECT_EQ(feeler.row("touch/friction_use", i)[0], 0);
}

}  // namespace
}  // namespace mimo::senses::touch
