#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "base/hash.h"
#include "env/state.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

// Remembers one number, refuses to load 13.
class CountingTask : public tasks::Task {
 public:
  CountingTask() : Task({{"count", 0.0}}) {}
  void reset(engine::Physics&, Random& random) override { number_ = random.next() | 1; }
  void evaluate(const engine::Physics&) override { terms_[0].value = static_cast<double>(++number_); }
  void save(ByteWriter& to) const override {
    Task::save(to);
    to.put(number_);
  }
  void load(ByteReader& from) override {
    Task::load(from);
    number_ = from.take<std::uint64_t>();
    require(number_ != 13, "13");
  }
  std::uint64_t number_ = 0;
};

env::EnvOptions counting(std::uint32_t max_steps = 0) {
  env::EnvOptions options;
  options.max_steps = max_steps;
  options.custom_task = [](const env::Identity&, std::size_t) { return std::make_unique<CountingTask>(); };
  return options;
}

CountingTask& task_of(const env::World& world) { return dynamic_cast<CountingTask&>(*world.agents()[0].task); }

// Puts a checksum under bytes that were changed, as someone with a hex editor and patience would.
void reseal(const env::World& world, Bytes& state) {
  ByteReader header{Span<const std::uint8_t>(state)};
  header.skip(24);
  env::StateFormat format;
  format.bytes = world.state_bytes();
  format.model = header.take<std::uint64_t>();
  format.layout = header.take<std::uint64_t>();
  env::seal_state(format, Span<std::uint8_t>(state));
}

engine::ModelPtr with(const scene::Object& object) {
  scene::Scene scene(named("free"));
  scene.add_body("mitten", "", nullptr);
  scene.add_object(object);
  return compile(scene);
}

std::string refusal(env::World& world, const Bytes& state) {
  try {
    load(world, state);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kInvalidArgument);
    return error.message();
  }
  return "";
}

TEST(State, ContinuesToTheBitFor10000Steps) {
  env::EnvOptions options;
  options.frame_skip = 1;
  for (const auto& [model, steps] : {std::pair(benchmark_model(), 10000), std::pair(floating_model(), 1000)}) {
    const auto first = make_world(model, options);
    const std::uint64_t seed = 5;
    first->reset(&seed, nullptr);
    for (int i = 0; i < 200; ++i) step(*first, i);
    const Bytes state = saved(*first);

    const auto second = make_world(model, options);
    for (int i = 0; i < 77; ++i) step(*second, 3 * i);  // somewhere else
    load(*second, state);
    EXPECT_EQ(saved(*second), state);
    for (int i = 0; i < steps; ++i) ASSERT_EQ(step(*first, i), step(*second, i)) << "step " << i;
    EXPECT_EQ(saved(*first), saved(*second));
  }
}

TEST(State, GoesBackInTheSameWorld) {
  const auto world = make_world(benchmark_model());
  world->reset(nullptr, nullptr);
  for (int i = 0; i < 50; ++i) step(*world, i);
  const Bytes state = saved(*world);
  const Bytes next = step(*world, 1000);
  for (int i = 0; i < 50; ++i) step(*world, i);
  load(*world, state);
  EXPECT_EQ(step(*world, 1000), next);
}

TEST(State, SavingAndObservingChangeNothing) {
  const auto plain = make_world(benchmark_model()), watched = make_world(benchmark_model());
  for (int i = 0; i < 100; ++i) {
    saved(*watched);
    observed(*watched);
    ASSERT_EQ(step(*plain, i), step(*watched, i)) << "step " << i;
  }
}

TEST(State, WhatFollowsFromItIsThatOfTheLoadedState) {
  const auto world = make_world(benchmark_model()), other = make_world(benchmark_model());
  for (int i = 0; i < 100; ++i) step(*world, i);
  const Bytes state = saved(*world);
  load(*other, state);
  const auto equal = [&](const mjtNum* a, const mjtNum* b, int n) { return std::equal(a, a + n, b); };
  const mjModel& model = world->model();
  // The reference is MuJoCo's own full recomputation.
  world->physics().forward();
  const mjData &a = world->data(), &b = other->data();
  EXPECT_TRUE(equal(a.xpos, b.xpos, 3 * model.nbody));
  EXPECT_TRUE(equal(a.geom_xmat, b.geom_xmat, 9 * model.ngeom));
  EXPECT_TRUE(equal(a.cam_xpos, b.cam_xpos, 3 * model.ncam));
  EXPECT_TRUE(equal(a.cvel, b.cvel, 6 * model.nbody));
  EXPECT_TRUE(equal(a.subtree_com, b.subtree_com, 3 * model.nbody));
  EXPECT_EQ(b.ncon, 0);

  // Nothing of the time before shows through: worlds with different pasts are now the same to look at.
  const auto third = make_world(benchmark_model());
  for (int i = 0; i < 30; ++i) step(*third, 7 * i);
  load(*third, state);
  EXPECT_TRUE(equal(third->data().sensordata, b.sensordata, model.nsensordata));
  EXPECT_TRUE(equal(third->data().qacc, b.qacc, model.nv));
  EXPECT_EQ(observed(*third), observed(*other));
}

TEST(State, HoldsAppliedForcesAndControls) {
  const auto world = make_world(benchmark_model()), other = make_world(benchmark_model());
  mjData& data = world->physics().data();
  data.xfrc_applied[6 * 2 + 2] = 30;
  data.qfrc_applied[1] = 2;
  std::fill_n(data.ctrl, world->model().nu, 0.25);
  load(*other, saved(*world));
  for (int i = 0; i < 20; ++i) {
    world->step({}, nullptr, {});
    other->step({}, nullptr, {});
  }
  EXPECT_EQ(saved(*world), saved(*other));
}

TEST(State, HoldsTheRandomStreamTheTaskAndTheElapsedSteps) {
  const auto world = make_world(floating_model(), counting(10)), other = make_world(floating_model(), counting(10));
  const std::uint64_t seed = 3;
  world->reset(&seed, nullptr);
  for (int i = 0; i < 7; ++i) step(*world, i);
  load(*other, saved(*world));
  for (int i = 0; i < 5; ++i) {
    double reward[2] = {};
    std::uint8_t truncated[2] = {};
    world->step({}, nullptr, {{&reward[0], 1}, {}, {&truncated[0], 1}});
    other->step({}, nullptr, {{&reward[1], 1}, {}, {&truncated[1], 1}});
    EXPECT_EQ(reward[0], reward[1]);
    EXPECT_EQ(truncated[0], truncated[1]);
    EXPECT_EQ(truncated[0], i >= 2);
  }
  world->reset(nullptr, nullptr);
  other->reset(nullptr, nullptr);
  EXPECT_EQ(saved(*world), saved(*other));
}

TEST(State, RefusesEveryFlippedBitAndEveryCut) {
  const auto world = make_world(floating_model());
  for (int i = 0; i < 20; ++i) step(*world, i);
  const Bytes state = saved(*world);
  const auto twin = make_world(floating_model());
  load(*twin, state);
  for (std::size_t bit = 0; bit < 8 * state.size(); bit += bit < 400 ? 1 : 13) {
    Bytes broken = state;
    broken[bit / 8] = static_cast<std::uint8_t>(broken[bit / 8] ^ (1u << (bit % 8)));
    ASSERT_NE(refusal(*world, broken), "") << "bit " << bit;
  }
  for (std::size_t length = 0; length < state.size(); length += length < 100 ? 1 : 17) {
    ASSERT_NE(refusal(*world, {state.begin(), state.begin() + static_cast<std::ptrdiff_t>(length)}), "");
  }
  Bytes longer = state;
  longer.push_back(0);
  EXPECT_NE(refusal(*world, longer), "");
  EXPECT_EQ(saved(*world), state);
  EXPECT_EQ(step(*world, 5), step(*twin, 5));
}

TEST(State, RefusesNumbersThatAreNotFiniteAndPartsThatDoNotWantTheirs) {
  const auto world = make_world(floating_model(), counting());
  CountingTask& task = task_of(*world);
  for (int i = 0; i < 20; ++i) step(*world, i);
  task.number_ = 1000;
  const Bytes state = saved(*world), block = observed(*world);

  Bytes infinite = state;
  const double bad = HUGE_VAL;
  std::memcpy(infinite.data() + infinite.size() - sizeof bad, &bad, sizeof bad);
  infinite[env::kStateHeaderBytes] ^= 1;  // another number of elapsed steps must not stay either
  reseal(*world, infinite);
  EXPECT_NE(refusal(*world, infinite).find("expected a finite number"), std::string::npos);
  EXPECT_EQ(saved(*world), state);

  task.number_ = 13;
  const Bytes unlucky = saved(*world);
  task.number_ = 1000;
  EXPECT_EQ(refusal(*world, unlucky), "13");
  EXPECT_EQ(task.number_, 1000u);
  EXPECT_EQ(saved(*world), state);
  EXPECT_EQ(observed(*world), block);
}

TEST(State, IsRefusedByAnotherModelOrTask) {
  const auto world = make_world(benchmark_model());
  EXPECT_EQ(refusal(*make_world(floating_model()), saved(*world)), "state: it was saved from another model");

  scene::Object ball;
  ball.name = "ball";
  ball.size = {0.04, 0, 0};
  ball.mass = 0.1;
  const auto with_ball = make_world(with(ball));
  ball.mass = 0.1001;
  const auto heavier = make_world(with(ball));
  EXPECT_EQ(refusal(*heavier, saved(*with_ball)), "state: it was saved from another model");
  ball.mass = 0.1;
  EXPECT_EQ(refusal(*make_world(with(ball)), saved(*with_ball)), "");

  const auto with_task = make_world(benchmark_model(), counting());
  EXPECT_NE(refusal(*with_task, saved(*world)).find("another task"), std::string::npos);
  EXPECT_NE(refusal(*world, saved(*with_task)).find("another task"), std::string::npos);
}

TEST(State, FitsAWorldWithOtherSenses) {
  const auto world = make_world(benchmark_model());
  for (int i = 0; i < 30; ++i) step(*world, i);
  auto deaf = blind();
  deaf.vestibular = {false, false, ""};
  deaf.proprioception = {};
  deaf.proprioception.torque = false;
  env::World other(benchmark_model(), {deaf}, {});
  load(other, saved(*world));
  step(*world, 1);
  step(other, 1);
  EXPECT_EQ(saved(*world), saved(other));
}

TEST(State, AFailedWorldHasNoneButTakesOne) {
  const auto world = make_world(benchmark_model()), healthy = make_world(benchmark_model());
  for (int i = 0; i < 20; ++i) step(*healthy, i);
  const Bytes state = saved(*healthy);
  world->physics().data().qvel[0] = 1e300;
  EXPECT_THROW(step(*world, 0), Error);
  EXPECT_THROW(saved(*world), Error);
  load(*world, state);
  EXPECT_EQ(step(*world, 1), step(*healthy, 1));
}

// Two worlds, one in the middle of an episode and one elsewhere, that become one.
void expect_to_continue(env::World& world, env::World& other) {
  const std::uint64_t seeds[] = {11, 12};
  world.reset(&seeds[0], nullptr);
  other.reset(&seeds[1], nullptr);
  for (int i = 0; i < 30; ++i) step(world, i);
  for (int i = 0; i < 9; ++i) step(other, 5 * i);
  load(other, saved(world));
  for (int i = 0; i < 60; ++i) {
    double reward[2] = {};
    std::uint8_t over[2] = {};
    const std::vector<float> actions = some_actions(world.action_size(), i);
    world.step(Span<const float>(actions), nullptr, {{&reward[0], 1}, {&over[0], 1}, {}});
    other.step(Span<const float>(actions), nullptr, {{&reward[1], 1}, {&over[1], 1}, {}});
    ASSERT_EQ(reward[0], reward[1]);
    ASSERT_EQ(over[0], over[1]);
    ASSERT_EQ(saved(world), saved(other)) << "step " << i;
  }
  world.reset(nullptr, nullptr);
  other.reset(nullptr, nullptr);
  EXPECT_EQ(saved(world), saved(other));
}

class TaskState : public testing::TestWithParam<const char*> {};

TEST_P(TaskState, Continues) {
  const engine::ModelPtr model = room_with_infant(GetParam());
  expect_to_continue(*make_world(model), *make_world(model));
}

INSTANTIATE_TEST_SUITE_P(Tasks, TaskState, testing::Values("reach", "standup", "selfbody"));

TEST(State, HoldsPositionControlLocksGearsAndGravity) {
  env::AgentOptions agent = blind();
  agent.actuation.mode = actuation::Mode::kPosition;
  env::World world(benchmark_model(), {agent}, {}), other(benchmark_model(), {agent}, {});
  world.physics().gear(3) = 0.5;
  world.physics().set_gravity({0, -3, -9.81});
  expect_to_continue(world, other);
  EXPECT_EQ(other.physics().gear(3), 0.5);

  const auto plain = make_world(benchmark_model()), locked = make_world(benchmark_model());
  const int lock = engine::find_lock(locked->model(), 5);
  ASSERT_GE(lock, 0);
  locked->physics().hold(lock, 0.1);
  expect_to_continue(*locked, *plain);
  EXPECT_EQ(engine::lock_angle(plain->model(), lock), engine::lock_angle(locked->model(), lock));
  EXPECT_EQ(benchmark_model()->eq_active[lock], 0);  // what all worlds share stays as it was
}

TEST(State, SavesAndLoadsQuickly) {
  const auto world = make_world(benchmark_model());
  for (int i = 0; i < 100; ++i) step(*world, i);
  Bytes state(world->state_bytes());
  double best = 1;
  for (int i = 0; i < 200; ++i) {
    const auto start = std::chrono::steady_clock::now();
    world->save(Span<std::uint8_t>(state));
    world->load(Span<const std::uint8_t>(state));
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  RecordProperty("microseconds", std::to_string(best * 1e6));
  RecordProperty("bytes", std::to_string(state.size()));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(best, 50e-6);  // what planning needs
#endif
}

}  // namespace
}  // namespace mimo::test
