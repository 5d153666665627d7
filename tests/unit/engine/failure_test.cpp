// Simulations that fail: each gives a status and a message, spares other worlds, and a reset repairs it.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <functional>
#include <limits>
#include <string>

#include "compat/mujoco.h"
#include "support/quiet.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// One way to make a world fail within 400 steps.
struct Trouble {
  const char* name;
  std::string xml;
  std::function<void(engine::Physics&)> cause;
  const char* message;
};

void PrintTo(const Trouble& trouble, std::ostream* stream) { *stream << trouble.name; }

// So few spheres are solved by MuJoCo, with a dense Jacobian, unless one asks for the other: then by ourselves.
std::string small_pile(const char* jacobian) { return pile(4, format("<option jacobian='{}'/>", jacobian)); }

// MuJoCo 4 has one buffer for contacts, constraints and the stack, and so for what two sizes limited before. As bare
// mj_step tells: of 36 kB the solver gets too little once all spheres touch, with 16 kB constraints are dropped.
#if MIMO_MUJOCO_4
constexpr const char *kSmallStack = "<size memory='36K'/>", *kOverflow = "stack overflow";
constexpr const char* kFewConstraints = "<size memory='16K'/>";
#else
constexpr const char *kSmallStack = "<size nstack='3000'/>", *kOverflow = "Stack overflow";
constexpr const char* kFewConstraints = "<size njmax='20'/>";
#endif

std::vector<Trouble> troubles() {
  const auto nothing = [](engine::Physics&) {};
  const auto push = [](double force) { return [force](engine::Physics& p) { p.data().xfrc_applied[6] = force; }; };
  return {
      // Enough for the fall, too little for the solver once all spheres touch.
      {"StackOverflow", pile(16, kSmallStack), nothing, kOverflow},
      {"PositionNaN", pile(4, ""), [](engine::Physics& p) { p.data().qpos[2] = kNaN; }, "QPOS"},
      {"PositionInfinite", pile(4, ""), [](engine::Physics& p) { p.data().qpos[2] = kInfinity; }, "QPOS"},
      {"VelocityNaN", pile(4, ""), [](engine::Physics& p) { p.data().qvel[3] = kNaN; }, "QVEL"},
      {"ForceNaN", small_pile("dense"), push(kNaN), "QACC"},
      {"ForceHuge", small_pile("dense"), push(1e300), "QACC"},
      {"ForceNaNSparse", small_pile("sparse"), push(kNaN), "QACC"},
      {"ForceHugeSparse", small_pile("sparse"), push(1e300), "QACC"},
      // omega dt = sqrt(2e4 N/m / 0.1 kg) 0.005 s = 2.2: above 2 the integrator's steps grow without bounds.
      {"Diverging", spring(2e4), nothing, "is unstable"},
  };
}

class EngineFailure : public QuietTest, public ::testing::WithParamInterface<Trouble> {};

void fail_once(engine::Physics& physics, const Trouble& trouble) {
  trouble.cause(physics);
  expect_error(Status::kSimulation, trouble.message, [&] { physics.step(400); });
}

TEST_P(EngineFailure, GivesStatusAndMessage) {
  engine::Physics physics(compiled(GetParam().xml), {});
  fail_once(physics, GetParam());
  EXPECT_TRUE(physics.failed());
}

TEST_P(EngineFailure, FailedWorldAcceptsOnlyReset) {
  engine::Physics physics(compiled(GetParam().xml), {});
  fail_once(physics, GetParam());
  const std::string hint = "needs a reset";
  expect_error(Status::kSimulation, hint, [&] { physics.step(1); });
  expect_error(Status::kSimulation, hint, [&] { physics.forward(); });
  expect_error(Status::kSimulation, hint, [&] { physics.update_poses(); });
  physics.reset();
  EXPECT_FALSE(physics.failed());
  EXPECT_EQ(physics.data().time, 0);
  physics.step(1);
}

TEST_P(EngineFailure, ResetEqualsFreshWorld) {
  const engine::ModelPtr model = compiled(GetParam().xml);
  engine::Physics fresh(model, {});
  engine::Physics failed(model, {});
  fail_once(failed, GetParam());
  failed.reset();
  EXPECT_EQ(trajectory(failed, 5), trajectory(fresh, 5));
}

TEST_P(EngineFailure, OtherWorldsContinueExactly) {
  const engine::ModelPtr model = compiled(pile(16, ""));
  engine::Physics alone(model, {});
  engine::Physics beside(model, {});
  const std::vector<double> expected = trajectory(alone, 200);
  std::vector<double> actual = trajectory(beside, 100);
  engine::Physics failing(compiled(GetParam().xml), {});
  fail_once(failing, GetParam());
  const std::vector<double> rest = trajectory(beside, 100);
  actual.insert(actual.end(), rest.begin(), rest.end());
  EXPECT_EQ(actual, expected);
}

INSTANTIATE_TEST_SUITE_P(Each, EngineFailure, ::testing::ValuesIn(troubles()),
                         [](const auto& trouble) { return std::string(trouble.param.name); });

using EngineSurvival = QuietTest;

// Two worlds of one model: the failure of one leaves the shared numbers alone.
TEST_F(EngineSurvival, WorldsOfOneModelAreIndependent) {
  const engine::ModelPtr model = compiled(pile(16, ""));
  engine::Physics alone(model, {});
  engine::Physics beside(model, {});
  engine::Physics failing(model, {});
  failing.data().qpos[2] = kNaN;
  expect_error(Status::kSimulation, "QPOS", [&] { failing.step(1); });
  EXPECT_EQ(trajectory(beside, 200), trajectory(alone, 200));
  failing.reset();
  alone.reset();
  EXPECT_EQ(trajectory(failing, 200), trajectory(alone, 200));
}

// The message says when: the fifth step of 5 ms starts at 0.02 s.
TEST_F(EngineSurvival, MessageNamesTheTime) {
  engine::Physics physics(compiled(pile(4, "")), {});
  physics.step(4);
  physics.data().qvel[0] = kNaN;
  expect_error(Status::kSimulation, "0.0200 s", [&] { physics.step(1); });
}

// Full buffers are survived with a warning, once an episode.
void expect_warning(const std::string& size, engine::Warning kind, const std::string& part) {
  engine::Physics physics(compiled(pile(16, size)), {});
  EXPECT_TRUE(physics.take_warnings().empty());
  physics.step(200);
  EXPECT_FALSE(physics.failed());
  const std::vector<engine::Note> notes = physics.take_warnings();
  ASSERT_FALSE(notes.empty());
  EXPECT_EQ(notes[0].kind, kind);
  EXPECT_TRUE(contains(notes[0].text, part));
  physics.step(10);
  EXPECT_TRUE(physics.take_warnings().empty()) << "a warning comes once";
  physics.reset();
  physics.step(200);
  EXPECT_EQ(physics.take_warnings().size(), notes.size()) << "a new episode, new warnings";
}

TEST_F(EngineSurvival, ContactBufferFull) {
  expect_warning(kFewContacts, engine::Warning::kContactsDropped, "contact");
}
TEST_F(EngineSurvival, ConstraintBufferFull) {
  expect_warning(kFewConstraints, engine::Warning::kConstraintsDropped, "onstraint");
}

// MuJoCo replaces a control that is not a number by zero, and we say so.
TEST_F(EngineSurvival, BadControl) {
  engine::Physics physics(compiled(spring(1)), {});
  physics.data().ctrl[0] = kNaN;
  physics.step(1);
  const std::vector<engine::Note> notes = physics.take_warnings();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].kind, engine::Warning::kBadControl);
  EXPECT_TRUE(contains(notes[0].text, "CTRL"));
  EXPECT_TRUE(std::isfinite(physics.data().qpos[0]));
}

}  // namespace
}  // namespace mimo::test
