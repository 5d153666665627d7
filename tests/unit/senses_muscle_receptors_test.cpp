// Receptors of muscles and joints, on a joint whose angle and motor are known.
#include <gtest/gtest.h>

#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

// Nothing moves it but the motor; gravity is off.
constexpr const char* kElbow = R"(
<mujoco>
  <compiler angle="radian"/><option timestep="0.005" gravity="0 0 0"/>
  <worldbody><body name="arm"><joint name="elbow" type="hinge" axis="0 1 0" limited="true" range="-1 2" damping="100"/>
    <geom size="0.05"/></body></worldbody>
  <actuator><motor name="biceps" joint="elbow" ctrllimited="true" ctrlrange="-2 4"/></actuator>
</mujoco>)";

std::unique_ptr<env::World> elbow() {
  env::AgentOptions options = blind();
  options.root = "arm";
  options.vestibular = {false, false, {}, ""};
  options.touch.force = false;
  options.proprioception.receptors = {true, true, true, true};
  env::EnvOptions worlds = without_renderer();
  worlds.frame_skip = 1;
  return std::make_unique<env::World>(compile(scene::Scene(from_text(kElbow))), std::vector<env::AgentOptions>{options},
                                      worlds);
}

// A third of the way up the joint's range the muscle that pulls down is a third of the way up its own, at 0.9 L0, the
// other at 1.0: with the usual drive 52.8 and 85.5 Hz of Ia, 17.7 and 54.7 of II (Mileusnic et al. 2006).
TEST(MuscleReceptors, SpindlesTellLengths) {
  const auto world = elbow();
  Observation block(*world);
  world->reset(nullptr, block.data());
  EXPECT_NEAR(block.at("proprioception/spindle_primary", "biceps/negative"), 52.8, 0.1);
  EXPECT_NEAR(block.at("proprioception/spindle_primary", "biceps/positive"), 85.5, 0.1);
  EXPECT_NEAR(block.at("proprioception/spindle_secondary", "biceps/negative"), 17.7, 0.1);
  EXPECT_NEAR(block.at("proprioception/spindle_secondary", "biceps/positive"), 54.7, 0.1);
  EXPECT_EQ(block.at("proprioception/tendon_organ", "biceps/positive"), 0);
  EXPECT_EQ(block.at("proprioception/joint_receptor", "elbow/low"), 0);
}

// Half of its force to the positive side, held: 95.9 Hz, 1.186 times as much after a second (Lin and Crago 2002).
TEST(MuscleReceptors, TendonOrgansTellForce) {
  const auto world = elbow();
  Observation block(*world);
  world->reset(nullptr, block.data());
  const std::vector<float> action = {2};
  for (int i = 0; i < 201; ++i) world->step({action.data(), 1}, block.data(), {});
  EXPECT_NEAR(block.at("proprioception/tendon_organ", "biceps/positive"), 95.9 * 1.186, 0.5);
  EXPECT_EQ(block.at("proprioception/tendon_organ", "biceps/negative"), 0);
}

// 0.0175 rad inside the upper limit are half of the way from the threshold: 50 Hz, and nothing at the other end.
TEST(MuscleReceptors, JointReceptorsTellWhichEnd) {
  const auto world = elbow();
  Observation block(*world);
  world->reset(nullptr, block.data());
  world->physics().data().qpos[0] = 2 - 0.0175;
  world->observe(block.data());
  EXPECT_NEAR(block.at("proprioception/joint_receptor", "elbow/high"), 50, 0.01);
  EXPECT_EQ(block.at("proprioception/joint_receptor", "elbow/low"), 0);
}

// An infant has them under torque and under muscles: two for each motor.
TEST(MuscleReceptors, AnInfantHasTwoMusclesAMotor) {
  for (const actuation::Mode mode : {actuation::Mode::kTorque, actuation::Mode::kMuscle}) {
    env::AgentOptions options = blind();
    options.actuation.mode = mode;
    options.proprioception.receptors = {true, true, true, true};
    const auto world = benchmark_world(options, without_renderer());
    Observation block(*world);
    world->reset(nullptr, block.data());
    const std::size_t motors = world->agents()[0].body.actuators.size();
    EXPECT_EQ(block["proprioception/spindle_primary"].size(), 2 * motors);
    EXPECT_EQ(block["proprioception/tendon_organ"].size(), 2 * motors);
    std::vector<float> all(world->action_size(), 1.0F);
    for (int i = 0; i < 5; ++i) world->step(all, block.data(), {});
    const std::vector<float> organs = block["proprioception/tendon_organ"];
    EXPECT_GT(organs[motors], 100);  // of the first motor's positive muscle
    if (mode == actuation::Mode::kTorque) {
      EXPECT_EQ(organs[0], 0);
    }
  }
}

}  // namespace
}  // namespace mimo::test
