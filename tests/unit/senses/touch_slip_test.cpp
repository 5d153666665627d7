// Slip and friction use, on a slope: a block that slides with a known speed, and one that sticks.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>

#include "base/format.h"
#include "compat/mujoco.h"
#include "touch_feeler.h"

namespace mimo::senses::touch {
namespace {

constexpr int kSlab = 1, kBlock = 2;
constexpr double kFriction = 0.5, kGravity = 9.81;

constexpr double kDrag = 20;  // Ns/m: against the block's sliding, so that its final speed is known

// A slab and a block on it, 1 kg. Not the slab is tilted but gravity, along x.
engine::ModelPtr slope(double angle, const std::string& cone) {
  return test::compiled(format(
      "<mujoco><option timestep='0.001' cone='{}' gravity='{} 0 {}'/>"
      "<default><geom friction='{}' condim='3' solref='0.02 1' solimp='0.95 0.99 0.001 0.5 1'/></default><worldbody>"
      "<body><geom type='box' size='2 .2 .05' pos='0 0 -.05'/></body>"
      "<body pos='-1.5 0 .01'><joint type='slide' axis='1 0 0' damping='{}'/><joint type='slide' axis='0 0 1'/><geom "
      "type='box' size='.06 .06 .01' mass='1'/></body></worldbody></mujoco>",
      cone, kGravity * std::sin(angle), -kGravity * std::cos(angle), kFriction, kDrag));
}

TouchOptions all_outputs() {
  TouchOptions options;
  options.wanted = MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE | MIMO_TOUCH_NORMAL_FORCE;
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

// Each sensor that feels something sees this slip; those on a face see it in the body's own directions.
void expect_slip(const Feeler& feeler, int body, const Vec3& expected) {
  int on_face = 0;
  for (const std::size_t i : pressed(feeler, body)) {
    const Vec3 slip = slip_of(feeler, i);
    EXPECT_NEAR(slip.norm(), expected.norm(), 0.02 * expected.norm());
    EXPECT_GT(feeler.row("touch/friction_use", i)[0], 0.98);
    if (std::abs(feeler.sensors()[i].normal().z()) < 0.999) continue;
    EXPECT_LT((slip - expected).norm(), 0.02 * expected.norm());
    ++on_face;
  }
  EXPECT_GT(on_face, 3);
}

TEST_P(TouchSlip, IsTheSpeedOfASlidingBlock) {
  const double angle = 0.7;
  Feeler feeler(slope(angle, GetParam()), {{kSlab, 0.05}, {kBlock, 0.01}}, all_outputs());
  feeler.physics.step(2000);
  for (int i = 0; i < 50 && pressed(feeler, kBlock).empty(); ++i) {  // it hops a little, as MuJoCo's blocks do
    feeler.physics.step(1);
    feeler.physics.forward();
    feeler.feel();
  }
  const double speed = kGravity * (std::sin(angle) - kFriction * std::cos(angle)) / kDrag;
  // So few joints are moved by mj_step itself; a block of MuJoCo 4 on a pyramidal cone hops more.
  EXPECT_NEAR(feeler.physics.data().qvel[0], speed, (MIMO_MUJOCO_4 ? 0.07 : 0.05) * speed);
  const Vec3 velocity(feeler.physics.data().qvel[0], 0, 0);
  expect_slip(feeler, kSlab, velocity);
  expect_slip(feeler, kBlock, -velocity);  // the slab slides backwards over the block's skin
}

TEST_P(TouchSlip, IsZeroWhereABlockSticks) {
  const double angle = 0.3;
  Feeler feeler(slope(angle, GetParam()), {{kSlab, 0.05}, {kBlock, 0.01}}, all_outputs());
  feeler.physics.step(2000);
  feeler.physics.forward();
  feeler.feel();
  const double creep = feeler.physics.data().qvel[0];
  EXPECT_GT(creep, 1e-5) << "MuJoCo's friction creeps";
  EXPECT_LT(creep, 0.5 * all_outputs().slip_threshold);
  double use = 0, force = 0;
  for (const std::size_t i : pressed(feeler, kBlock)) {
    EXPECT_TRUE(feeler.row("touch/slip", i).isZero());
    const double normal = feeler.row("touch/force", i)[0];
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
  feeler.physics.step(2000);
  feeler.physics.forward();
  feeler.feel();
  const auto sensors = pressed(feeler, kBlock);
  ASSERT_FALSE(sensors.empty());
  for (const std::size_t i : sensors) EXPECT_GT(slip_of(feeler, i).norm(), 0);
}

TEST(TouchSlip, UsesNoFrictionInFrictionlessContacts) {
  const auto model = test::compiled(
      "<mujoco><option timestep='0.005'/><worldbody><body><geom type='box' size='1 1 .05'/></body><body pos='0 0 .1'>"
      "<freejoint/><geom type='sphere' size='.05' condim='1'/></body></worldbody></mujoco>");
  const_cast<mjModel*>(model.get())->geom_condim[0] = 1;
  Feeler feeler(model, {{kBlock, 0.02}}, all_outputs());
  feeler.physics.step(2000);
  feeler.physics.forward();
  feeler.feel();
  const auto sensors = pressed(feeler, kBlock);
  ASSERT_FALSE(sensors.empty());
  for (const std::size_t i : sensors) EXPECT_EQ(feeler.row("touch/friction_use", i)[0], 0);
}

}  // namespace
}  // namespace mimo::senses::touch
