// Receptors of muscles and joints, on a joint whose angle and motor are known.
#include <gtest/gtest.h>

#include <cmath>

#include "env/attached.h"
#include "support/access.h"
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
  <equality><joint name="lock" joint1="elbow" active="false"/></equality>
  <actuator><motor name="biceps" joint="elbow" ctrllimited="true" ctrlrange="-2 4"/></actuator>
</mujoco>)";

env::AgentOptions of_elbow() {
  env::AgentOptions options = blind();
  options.root = "arm";
  options.vestibular.wanted = 0;
  options.touch.wanted = 0;
  options.proprioception.wanted |= senses::kMuscleReceptors;
  return options;
}

std::unique_ptr<env::World> elbow(const env::AgentOptions& options = of_elbow()) {
  env::EnvOptions worlds = without_renderer();
  worlds.frame_skip = 1;
  return std::make_unique<env::World>(compile(scene::Scene(from_text(kElbow))), std::vector<env::AgentOptions>{options},
                                      worlds);
}

void step(env::World& world, Observation& block, double seconds) {
  for (int i = 0; i < std::lround(seconds / world.step_seconds()); ++i) world.step({}, block.data(), {});
}

constexpr auto kDrive = MIMO_ACTUATOR_FUSIMOTOR_DRIVE;
const Values kUsual = {70, 70, 70, 70}, kNone = {0, 0, 0, 0};

// A third of the way up the joint's range the muscle that pulls down is a third of the way up its own, at 0.9 L0, the
// other at 1.0: with the usual drive 52.8 and 85.5 Hz of Ia, 17.7 and 54.7 of II (Mileusnic et al. 2006).
TEST(MuscleReceptors, SpindlesReportLengths) {
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
TEST(MuscleReceptors, TendonOrgansReportForce) {
  const auto world = elbow();
  Observation block(*world);
  world->reset(nullptr, block.data());
  const std::vector<float> action = {2};
  for (int i = 0; i < 201; ++i) world->step({action.data(), 1}, block.data(), {});
  EXPECT_NEAR(block.at("proprioception/tendon_organ", "biceps/positive"), 95.9 * 1.186, 0.5);
  EXPECT_EQ(block.at("proprioception/tendon_organ", "biceps/negative"), 0);
}

// Without drive a muscle of 0.9 L0 is silent, one of 1.0 L0 comes down to 12.2 Hz of Ia and 20.7 of II (Mileusnic et
// al. 2006); it creeps there, and is 1.5 and 0.7 Hz away after 20 s. An episode starts as usual.
TEST(MuscleReceptors, AHostDrivesTheirSpindles) {
  const auto world = elbow();
  Observation block(*world);
  world->reset(nullptr, block.data());
  const std::vector<std::uint8_t> usual = block.bytes();
  EXPECT_EQ(get(*world, kDrive, {0}), kUsual);
  set(*world, kDrive, {0}, kNone);
  EXPECT_EQ(get(*world, kDrive, {0}), kNone);
  step(*world, block, 20);
  EXPECT_EQ(block.at("proprioception/spindle_primary", "biceps/negative"), 0);
  EXPECT_EQ(block.at("proprioception/spindle_secondary", "biceps/negative"), 0);
  EXPECT_NEAR(block.at("proprioception/spindle_primary", "biceps/positive"), 12.2 + 1.5, 0.1);
  EXPECT_NEAR(block.at("proprioception/spindle_secondary", "biceps/positive"), 20.7 + 0.7, 0.1);
  // The first two numbers are of the muscle that pulls to the negative side.
  set(*world, kDrive, {0}, {70, 70, 0, 0});
  step(*world, block, 20);
  EXPECT_NEAR(block.at("proprioception/spindle_primary", "biceps/negative"), 52.8, 0.6);
  EXPECT_LT(block.at("proprioception/spindle_primary", "biceps/positive"), 14);
  world->reset(nullptr, block.data());
  EXPECT_EQ(get(*world, kDrive, {0}), kUsual);
  EXPECT_EQ(block.bytes(), usual);
}

TEST(MuscleReceptors, RefuseImpossibleRates) {
  const auto world = elbow();
  for (const double rate : {-1.0, 501.0}) {
    EXPECT_THROW(set(*world, kDrive, {0}, {70, rate, 70, 70}), Error) << rate;
    EXPECT_EQ(get(*world, kDrive, {0}), kUsual);
  }
  env::AgentOptions without = of_elbow();
  without.proprioception.wanted &= ~senses::kSpindles;
  EXPECT_TRUE(get(*elbow(without), kDrive, {0}).empty());
}

// Half way through a stretch under a drive of the host's, with tendon organs still adapting.
TEST(MuscleReceptors, ArePartOfTheState) {
  const auto world = elbow(), other = elbow();
  Observation block(*world), again(*other);
  world->reset(nullptr, block.data());
  set(*world, kDrive, {0}, {120, 30, 0, 90});
  const std::vector<float> action = {3};
  for (int i = 0; i < 20; ++i) world->step({action.data(), 1}, block.data(), {});
  std::vector<std::uint8_t> state(world->state_bytes());
  world->save(state);
  EXPECT_EQ(other->load(state).fresh, 0U);
  EXPECT_EQ(get(*other, kDrive, {0}), (Values{120, 30, 0, 90}));
  step(*world, block, 0.05);
  step(*other, again, 0.05);
  EXPECT_EQ(block.bytes(), again.bytes());
}

// The lock holds 1 Nm up, a quarter of what the motor could: 40 Hz ln(1 + 20 / 4) = 71.67 Hz in the end.
TEST(MuscleReceptors, TendonOrgansReportForcesOfPositionControl) {
  env::AgentOptions options = of_elbow();
  options.actuation.mode = actuation::Mode::kPosition;
  const auto world = elbow(options);
  Observation block(*world);
  world->reset(nullptr, block.data());
  EXPECT_EQ(block.at("proprioception/tendon_organ", "biceps/positive"), 0);
  world->physics().data().qfrc_applied[0] = -1;
  step(*world, block, 30);
  EXPECT_NEAR(block.at("proprioception/tendon_organ", "biceps/positive"), 71.67, 0.4);
  EXPECT_EQ(block.at("proprioception/tendon_organ", "biceps/negative"), 0);
  world->physics().data().qfrc_applied[0] = 1;  // half of what it could to the other side: 40 ln 11
  step(*world, block, 30);
  EXPECT_NEAR(block.at("proprioception/tendon_organ", "biceps/negative"), 95.92, 0.4);
}

// Attached to a host's simulation they tell the same bytes, under the same drive, before and after a load.
TEST(MuscleReceptors, ReportTheSameWhenAttached) {
  env::AgentOptions options = of_elbow();
  options.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_ACTUATION;
  const auto world = elbow(options);
  Observation block(*world);
  world->reset(nullptr, block.data());
  const Values drive = {120, 30, 0, 90};
  set(*world, kDrive, {0}, drive);
  const engine::ModelPtr model = compile(scene::Scene(from_text(kElbow)));
  const env::CompiledWorld compiled{model, {options}, without_renderer(), {}};
  env::Attached senses(compiled, 0);
  std::vector<std::uint8_t> theirs(senses.layout().bytes());
  engine::Physics host(model, {});
  host.forward();
  senses.reset(host.data(), nullptr);
  ASSERT_EQ(senses.driven().size(), 1U);
  senses.drive_spindles(senses.driven(), drive);
  const std::vector<float> action = {3};
  const auto both = [&](env::Attached& attached) {
    world->step({action.data(), 1}, block.data(), {});
    host.data().ctrl[0] = 3;
    host.step(1);
    attached.advance(host.data());
    attached.observe(host.data(), theirs.data());
    EXPECT_EQ(theirs, block.bytes());
  };
  for (int i = 0; i < 20; ++i) both(senses);
  std::vector<std::uint8_t> state(senses.state_bytes());
  senses.save(state);
  env::Attached next(compiled, 0);
  EXPECT_EQ(next.load(state).fresh, 0U);
  for (int i = 0; i < 20; ++i) both(next);
  const std::vector<std::int32_t> nobody = {1};
  EXPECT_THROW(next.drive_spindles(nobody, drive), Error);
  EXPECT_THROW(next.drive_spindles(next.driven(), Values{0, 0, 0}), Error);
  EXPECT_THROW(next.drive_spindles(next.driven(), Values{0, 0, 0, 501}), Error);
}

// 0.0175 rad inside the upper limit are half of the way from the threshold: 50 Hz, and nothing at the other end.
TEST(MuscleReceptors, JointReceptorsReportTheEnd) {
  const auto world = elbow();
  Observation block(*world);
  world->reset(nullptr, block.data());
  world->physics().data().qpos[0] = 2 - 0.0175;
  world->observe(block.data());
  EXPECT_NEAR(block.at("proprioception/joint_receptor", "elbow/high"), 50, 0.01);
  EXPECT_EQ(block.at("proprioception/joint_receptor", "elbow/low"), 0);
}

// An infant has them under torque and under muscles: two for each motor.
TEST(MuscleReceptors, HaveTwoMusclesPerMotor) {
  for (const actuation::Mode mode : {actuation::Mode::kTorque, actuation::Mode::kMuscle}) {
    env::AgentOptions options = blind();
    options.actuation.mode = mode;
    options.proprioception.wanted |= senses::kMuscleReceptors;
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
