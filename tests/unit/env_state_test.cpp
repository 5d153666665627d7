#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "base/bytes.h"
#include "compat/mujoco.h"
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

// The bytes of a section.
std::uint8_t* at(Bytes& state, const std::string& name) {
  const auto found = std::search(state.begin(), state.end(), name.begin(), name.end());
  EXPECT_NE(found, state.end());
  return &*found + name.size();
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
    const auto says = [&](const char* words) { return error.message().find(words) != std::string::npos; };
    const bool newer = says("needs a newer library"), mismatch = says("it was saved from");
    EXPECT_EQ(error.status(), newer      ? Status::kUnsupported
                              : mismatch ? Status::kMismatch
                                         : Status::kFile)
        << error.message();
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

TEST(State, ReturnsToAnEarlierTime) {
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

TEST(State, DerivedQuantitiesFollowTheLoadedState) {
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

TEST(State, RefusesInfiniteNumbersAndInvalidSections) {
  const auto world = make_world(floating_model(), counting());
  CountingTask& task = task_of(*world);
  for (int i = 0; i < 20; ++i) step(*world, i);
  task.number_ = 1000;
  const Bytes state = saved(*world), block = observed(*world);

  Bytes infinite = state;
  const double bad = HUGE_VAL;
  std::memcpy(infinite.data() + infinite.size() - sizeof bad, &bad, sizeof bad);
  at(infinite, "episode")[0] ^= 1;                // another number of elapsed steps must not stay either
  env::seal_state(Span<std::uint8_t>(infinite));  // as someone with a hex editor and patience would
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
  EXPECT_EQ(refusal(*make_world(floating_model()), saved(*world)),
            "state: it was saved from another model, or from infants of another age");

  scene::Object ball;
  ball.name = "ball";
  ball.size = {0.04, 0, 0};
  ball.mass = 0.1;
  const auto with_ball = make_world(with(ball));
  ball.mass = 0.1001;
  const auto heavier = make_world(with(ball));
  EXPECT_EQ(refusal(*heavier, saved(*with_ball)),
            "state: it was saved from another model, or from infants of another age");
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
  deaf.vestibular.wanted = 0;
  deaf.proprioception = {};
  deaf.proprioception.wanted &= ~MIMO_PROPRIOCEPTION_TORQUE;
  env::World other(benchmark_model(), {deaf}, {});
  load(other, saved(*world));
  step(*world, 1);
  step(other, 1);
  EXPECT_EQ(saved(*world), saved(other));
}

TEST(State, FailedWorldsLoadButDoNotSave) {
  const auto world = make_world(benchmark_model()), healthy = make_world(benchmark_model());
  for (int i = 0; i < 20; ++i) step(*healthy, i);
  const Bytes state = saved(*healthy);
  world->physics().data().qvel[0] = 1e300;
  EXPECT_THROW(step(*world, 0), Error);
  EXPECT_THROW(saved(*world), Error);
  load(*world, state);
  EXPECT_EQ(step(*world, 1), step(*healthy, 1));
}

// What the task has counted in the episode, of tasks that have goals.
std::vector<double> achieved(const env::World& world) {
  const std::unique_ptr<tasks::Task>& task = world.agents()[0].task;
  std::vector<double> numbers(task == nullptr ? 0 : static_cast<std::size_t>(task->goal_size()));
  if (!numbers.empty()) task->achieved(world.data(), numbers.data());
  return numbers;
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

// In a cone that holds everything there is something to count.
TEST(State, HoldsCounters) {
  env::EnvOptions options;
  options.parameters.set("handregard/angle", 3.14);
  const engine::ModelPtr model = room_with_infant("babybench-cubes");
  const auto world = make_world(model, options), other = make_world(model, options);
  world->reset(nullptr, nullptr);
  other->reset(nullptr, nullptr);
  for (int i = 0; i < 7; ++i) step(*world, i);
  load(*other, saved(*world));
  EXPECT_EQ(achieved(*other), std::vector<double>(8, 7));
  step(*other, 7);
  EXPECT_EQ(achieved(*other), std::vector<double>(8, 8));
}

class TaskState : public testing::TestWithParam<const char*> {};

TEST_P(TaskState, Continues) {
  const engine::ModelPtr model = room_with_infant(GetParam());
  expect_to_continue(*make_world(model), *make_world(model));
}

INSTANTIATE_TEST_SUITE_P(Tasks, TaskState,
                         testing::Values("reach", "standup", "selfbody", "rollover", "babybench-crib",
                                         "babybench-cubes"));

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
  EXPECT_EQ(((*benchmark_model()).*compat::kLockFlags)[lock], 0);  // what all worlds share stays as it was
}

std::unique_ptr<env::World> late_world(double force, double velocity) {
  env::AgentOptions agent = blind();
  agent.touch.everywhere = 0.1;
  if (force > 0) agent.limits.push_back({"touch/force", {1, 0, 0, force}});
  if (velocity > 0) agent.limits.push_back({"proprioception/velocity", {1, 0.05, 0, velocity}});
  return std::make_unique<env::World>(benchmark_model(), std::vector<env::AgentOptions>{agent}, env::EnvOptions{});
}

// Sections that the state lacks start afresh, others go on, and all else is as in any world.
TEST(State, SectionsThatAStateLacksStartAfresh) {
  const auto world = late_world(0.03, 0.02);
  for (int i = 0; i < 20; ++i) step(*world, i);
  const Bytes state = saved(*world);
  const std::string force = "delay/touch/force", velocity = "delay/proprioception/velocity";

  EXPECT_EQ(late_world(0.03, 0.02)->load(Span<const std::uint8_t>(state)).fresh_names, "");
  const env::LoadReport perfect = late_world(0, 0)->load(Span<const std::uint8_t>(state));
  EXPECT_EQ(perfect.fresh_names, "");
  EXPECT_EQ(perfect.ignored_names, velocity + ", " + force);
  EXPECT_EQ(perfect.ignored, 2u);
  const env::LoadReport slower = late_world(0.04, 0.02)->load(Span<const std::uint8_t>(state));
  EXPECT_EQ(slower.fresh_names, force);
  EXPECT_EQ(slower.ignored_names, "");

  // Trajectories do not depend on what is sensed; what was never late is the same at once.
  const auto prompt = late_world(0, 0), other = late_world(0.05, 0);
  prompt->load(Span<const std::uint8_t>(state));
  EXPECT_EQ(other->load(Span<const std::uint8_t>(state)).fresh_names, force);
  EXPECT_EQ(observed(*prompt), observed(*other));
  Bytes first;
  for (int i = 20; i < 40; ++i) {
    const Bytes now = step(*prompt, i), late = step(*other, i);
    const observation::Field& touch = other->layout()[other->layout().size() - 1];
    ASSERT_EQ(touch.name, "touch/force");
    EXPECT_TRUE(std::equal(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(touch.offset), late.begin()));
    if (i == 20) first = now;
    if (i > 25) continue;
    const auto start = static_cast<std::ptrdiff_t>(touch.offset);
    EXPECT_TRUE(std::equal(first.begin() + start, first.begin() + start + static_cast<std::ptrdiff_t>(touch.bytes()),
                           late.begin() + start))
        << i;
  }
}

TEST(State, NoiseContinuesForNewFields) {
  const auto plain = late_world(0, 0), noisy = late_world(0, 0.02), twin = late_world(0, 0.02);
  const std::uint64_t seed = 3;
  plain->reset(&seed, nullptr);
  noisy->reset(&seed, nullptr);
  for (int i = 0; i < 10; ++i) step(*plain, i), step(*noisy, i);
  twin->load(Span<const std::uint8_t>(saved(*plain)));
  // After the delay nothing is left of the start.
  for (int i = 10; i < 13; ++i) step(*noisy, i), step(*twin, i);
  for (int i = 13; i < 20; ++i) EXPECT_EQ(step(*noisy, i), step(*twin, i));
}

TEST(State, RefusesStatesOfOtherActuations) {
  env::AgentOptions agent = blind();
  agent.actuation.mode = actuation::Mode::kPosition;
  env::World angles(benchmark_model(), {agent}, {});
  const auto torques = make_world(benchmark_model());
  EXPECT_NE(refusal(angles, saved(*torques)).find("another task, actuation"), std::string::npos);
  EXPECT_NE(refusal(*torques, saved(angles)).find("agent/actuation"), std::string::npos);
}

// Of a library to come: a section more that may be left out, and one that may not.
TEST(State, ToleratesSectionsToComeUnlessTheyAreEssential) {
  int memory = 5;
  const auto sections = [&](bool more, bool essential, std::uint32_t version) {
    std::vector<Section> all(1);
    all[0].name = "old";
    all[0].version = version;
    if (more) {
      all.push_back(all[0]);
      all[1].name = "new";
      all[1].essential = essential;
    }
    for (Section& section : all) {
      section.save = [&](ByteWriter& to) { to.put(memory); };
      section.load = [&](ByteReader& from) { memory = from.take<int>(); };
      section.forget = [&] { memory = -1; };
    }
    return all;
  };
  const auto state_of = [&](const env::Archive& archive) {
    Bytes state(archive.bytes());
    archive.save(Span<std::uint8_t>(state));
    return state;
  };
  env::Archive today(7, sections(false, false, 1));
  const Bytes newer = state_of(env::Archive(7, sections(true, false, 1)));
  memory = 6;
  EXPECT_EQ(today.load(Span<const std::uint8_t>(newer)).ignored_names, "new");
  EXPECT_EQ(memory, 5);
  const auto refused = [&](const Bytes& state) {
    try {
      today.load(Span<const std::uint8_t>(state));
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  EXPECT_NE(refused(state_of(env::Archive(7, sections(true, true, 1)))).find("\"new\" has no use here"),
            std::string::npos);
  EXPECT_EQ(refused(state_of(env::Archive(7, sections(false, false, 2)))),
            "state: version 2 of its section \"old\" needs a newer library, this one reads up to 1");
  EXPECT_EQ(refused(state_of(env::Archive(8, sections(false, false, 1)))),
            "state: it was saved from another model, or from infants of another age");
  env::Archive tomorrow(7, sections(true, false, 2));
  EXPECT_EQ(tomorrow.load(Span<const std::uint8_t>(state_of(today))).fresh_names, "new");
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
