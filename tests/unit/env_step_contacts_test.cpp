// Contacts of whole environment steps, against the conservation of momentum; and warnings, counted.
#include <gtest/gtest.h>

#include "support/access.h"
#include "support/tiny.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

constexpr double kStep = 0.001, kMass = 0.3, kGravity = 9.81;
constexpr int kSkip = 100;  // physics steps in an environment step

// A ball of 5 cm that falls from 20 cm: it lands, and leaves the floor again, within an environment step of 0.1 s.
env::World falling(bool recorded) {
  env::EnvOptions options;
  options.frame_skip = kSkip;
  options.step_contacts = recorded;
  return env::World(compiled("<mujoco><option timestep='0.001'/><worldbody><geom type='plane' size='1 1 .1' "
                             "solref='-3000 -3'/><body pos='0 0 .25'><freejoint/><geom size='.05' mass='0.3' "
                             "solref='-3000 -3'/></body></worldbody></mujoco>"),
                    {}, options);
}

TEST(StepContacts, ImpulseIsTheChangeOfMomentum) {
  env::World world = falling(true);
  bool bounced = false;
  for (int step = 0; step < 20; ++step) {
    const Values before = get(world, MIMO_JOINT_VELOCITY, {0});
    world.step({}, nullptr, {});
    const Values after = get(world, MIMO_JOINT_VELOCITY, {0});
    const int pairs = access::kind_of(MIMO_STEP_CONTACT).count(world);
    ASSERT_LE(pairs, 1);
    const double impulse = pairs == 0 ? 0 : get(world, MIMO_STEP_CONTACT_IMPULSE)[2];
    const double gravity = -kMass * kGravity * kSkip * kStep;
    EXPECT_NEAR(impulse + gravity, kMass * (after[2] - before[2]), 1e-9) << step;
    if (pairs == 0) continue;
    const double start = get(world, MIMO_STEP_CONTACT_START)[0], end = get(world, MIMO_STEP_CONTACT_END)[0];
    EXPECT_GE(start, 0);
    EXPECT_LT(start, end);
    EXPECT_LE(end, kSkip * kStep + 1e-12);
    EXPECT_EQ(get(world, MIMO_STEP_CONTACT_GEOMS), (Values{0, 1}));
    EXPECT_EQ(get(world, MIMO_STEP_CONTACT_BODIES), (Values{0, 1}));
    EXPECT_NEAR(get(world, MIMO_STEP_CONTACT_PEAK_POSITION)[2], 0, 0.02);
    EXPECT_GT(get(world, MIMO_STEP_CONTACT_PEAK_FORCE)[2], impulse / (end - start)) << "more than on average";
    bounced = bounced || (before[2] < -0.5 && after[2] > 0 && access::kind_of(MIMO_CONTACT).count(world) == 0);
  }
  EXPECT_TRUE(bounced) << "a contact that began and ended between two looks at the world";
}

TEST(StepContacts, ChangeNothingAndEndWithAReset) {
  env::World recorded = falling(true), plain = falling(false);
  for (int step = 0; step < 10; ++step) {
    recorded.step({}, nullptr, {});
    plain.step({}, nullptr, {});
    EXPECT_EQ(copy(recorded.data().qpos, 7), copy(plain.data().qpos, 7));
  }
  recorded.step_physics(400);
  const Bytes state = saved(recorded);
  ASSERT_GT(access::kind_of(MIMO_STEP_CONTACT).count(recorded), 0);
  load(recorded, state);
  EXPECT_EQ(access::kind_of(MIMO_STEP_CONTACT).count(recorded), 0);
  recorded.step_physics(400);
  recorded.reset(nullptr, nullptr);
  EXPECT_EQ(access::kind_of(MIMO_STEP_CONTACT).count(recorded), 0);
  expect_error(Status::kUnsupported, "set step_contacts", [&] { access::kind_of(MIMO_STEP_CONTACT).count(plain); });
}

// ---- Warnings -------------------------------------------------------------------------------------------------------

double warnings(env::World& world, engine::Warning kind) {
  return get(world, MIMO_WARNING_STEPS, {static_cast<std::int32_t>(kind)})[0];
}

TEST(Warnings, AreAbsentFromACleanRun) {
  const auto world = make_world(benchmark_model());
  for (int i = 0; i < 50; ++i) step(*world, i);
  EXPECT_EQ(get(*world, MIMO_WARNING_STEPS), Values(engine::kWarnings, 0));
}

TEST(Warnings, CountStepsThatDropContacts) {
  const std::string second_floor = "<worldbody><geom type='plane' size='1 1 .1'/></worldbody>";
  env::World world(compiled(pile(16, kFewContacts + second_floor)), {}, {});
  world.physics().step(5);
  EXPECT_EQ(warnings(world, engine::Warning::kContactsDropped), 0) << "they have not landed yet";
  world.physics().step(200);
  const double landed = warnings(world, engine::Warning::kContactsDropped);
  EXPECT_GT(landed, 100);
  world.physics().forward();
  EXPECT_EQ(warnings(world, engine::Warning::kContactsDropped), landed) << "looking is no step";
  world.physics().step(7);
  EXPECT_EQ(warnings(world, engine::Warning::kContactsDropped), landed + 7);
  world.reset(nullptr, nullptr);
  EXPECT_EQ(warnings(world, engine::Warning::kContactsDropped), landed + 7) << "since the world was made";
  set(world, MIMO_WARNING_STEPS, {static_cast<std::int32_t>(engine::Warning::kContactsDropped)}, Values{0});
  EXPECT_EQ(warnings(world, engine::Warning::kContactsDropped), 0);
}

TEST(Warnings, SolverAtItsLimit) {
  env::World world(compiled(pile(16, "<option iterations='1' tolerance='0'/>")), {}, {});
  world.physics().step(300);
  EXPECT_GT(warnings(world, engine::Warning::kNotConverged), 100);
}

TEST(Warnings, Divergence) {
  const auto fail_by = [](mimo_quantity quantity, const Values& values) {
    env::World world = falling(false);
    set(world, quantity, {0}, values);
    EXPECT_THROW(world.step({}, nullptr, {}), Error);
    world.reset(nullptr, nullptr);
    return get(world, MIMO_WARNING_STEPS);
  };
  EXPECT_EQ(fail_by(MIMO_JOINT_POSITION, {1e200, 0, 0, 1, 0, 0, 0})[3], 1);
  EXPECT_EQ(fail_by(MIMO_JOINT_VELOCITY, {1e200, 0, 0, 0, 0, 0})[4], 1);
  EXPECT_EQ(fail_by(MIMO_JOINT_FORCE, {1e200, 0, 0, 0, 0, 0})[5], 1);
}

}  // namespace
}  // namespace mimo::test
