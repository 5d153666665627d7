// Steps of a world: times of fields, actions, episodes, seeds.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <limits>

#include "support/block.h"
#include "support/numbers.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

std::vector<double> state(const env::World& world) {
  std::vector<double> all = copy(world.data().qpos, world.model().nq);
  all.insert(all.end(), world.data().qvel, world.data().qvel + world.model().nv);
  return all;
}

TEST(EnvStep, ObserveRepeatsTheBlockOfReset) {
  const auto world = benchmark_world();
  Observation reset(*world), observed(*world);
  for (int step = 0; step < 30; ++step) world->step(some_actions(*world, step), nullptr, {});
  world->reset(nullptr, reset.data());
  world->observe(observed.data());
  EXPECT_EQ(observed.bytes(), reset.bytes());
}

// Observing between the steps changes neither states nor blocks, to the bit.
TEST(EnvStep, ObserveKeepsTheTrajectory) {
  const auto plain = benchmark_world();
  const auto observed = benchmark_world();
  Observation one(*plain), two(*observed), looked(*observed);
  for (int step = 0; step < 100; ++step) {
    plain->step(some_actions(*plain, step), one.data(), {});
    observed->step(some_actions(*observed, step), two.data(), {});
    ASSERT_EQ(one.bytes(), two.bytes()) << "step " << step;
    ASSERT_EQ(state(*plain), state(*observed)) << "step " << step;
    observed->observe(looked.data());
  }
  EXPECT_GT(plain->data().ncon, 3);
}

// A step without a block is the same step.
TEST(EnvStep, WithoutABlock) {
  const auto with = benchmark_world();
  const auto without = benchmark_world();
  Observation block(*with);
  for (int step = 0; step < 60; ++step) {
    with->step(some_actions(*with, step), block.data(), {});
    without->step(some_actions(*without, step), nullptr, {});
  }
  EXPECT_EQ(state(*with), state(*without));
}

// With one physics step a step: fields of the step's start are what observe gave before it (the controls were the same
// then), fields of its end are what observe gives after it, and not the other way round.
TEST(EnvStep, FieldsBelongToTheirTime) {
  env::AgentOptions agent = blind();
  agent.proprioception.wanted |= MIMO_PROPRIOCEPTION_JOINT_TORQUE;
  env::EnvOptions options = without_renderer();
  options.frame_skip = 1;
  const auto world = benchmark_world(agent, options);
  const std::vector<float> actions = some_actions(*world, 0);
  for (int step = 0; step < 150; ++step) world->step(actions, nullptr, {});
  Observation before(*world), block(*world), after(*world);
  world->observe(before.data());
  world->step(actions, block.data(), {});
  world->observe(after.data());
  std::size_t at_start = 0;
  for (std::size_t i = 0; i < world->layout().size(); ++i) {
    const observation::Field& field = world->layout()[i];
    SCOPED_TRACE(field.name);
    if (field.time == observation::Time::kLastStart) {
      EXPECT_EQ(block[field.name], before[field.name]);
      EXPECT_NE(block[field.name], after[field.name]);
      ++at_start;
    } else {
      EXPECT_EQ(block[field.name], after[field.name]);
      const bool changes = field.name != "proprioception/control" && field.name != "proprioception/motor_torque";
      EXPECT_EQ(block[field.name] != before[field.name], changes);
    }
  }
  EXPECT_EQ(at_start, 5u);  // torque, joint torque, acceleration, angular velocity, touch
}

TEST(EnvStep, ActionsAreClipped) {
  const auto world = benchmark_world();
  const float infinity = std::numeric_limits<float>::infinity();
  const auto& low = world->agents()[0].actuation->low();
  const auto& high = world->agents()[0].actuation->high();
  struct Known {
    float action;
    const std::vector<float>& control;
  };
  for (const Known& known : {Known{5, high}, {infinity, high}, {-5, low}, {-infinity, low}}) {
    world->reset(nullptr, nullptr);
    world->step(std::vector<float>(44, known.action), nullptr, {});
    for (std::size_t i = 0; i < 44; ++i) EXPECT_EQ(world->data().ctrl[i], static_cast<double>(known.control[i]));
  }
  EXPECT_EQ(high[0], 0.765f);  // hip_bend, from the paper's -10.58..8.09 Nm
  EXPECT_EQ(low[0], -1.f);
}

TEST(EnvStep, NoActionsKeepTheControls) {
  const auto world = benchmark_world();
  world->step(std::vector<float>(44, 0.25f), nullptr, {});
  world->step({}, nullptr, {});
  EXPECT_EQ(copy(world->data().ctrl, 44), std::vector<double>(44, 0.25));
  world->reset(nullptr, nullptr);
  EXPECT_EQ(copy(world->data().ctrl, 44), std::vector<double>(44, 0));
}

TEST(EnvStep, FrameSkip) {
  for (const int skip : {1, 2, 7}) {
    env::EnvOptions options = without_renderer();
    options.frame_skip = skip;
    const auto world = benchmark_world(blind(), options);
    engine::Physics plain(benchmark_model(), {});
    for (int step = 0; step < 3; ++step) {
      world->step({}, nullptr, {});
      plain.step(skip);
    }
    EXPECT_TRUE(close(3 * skip * 0.005, world->data().time));
    EXPECT_EQ(state(*world), [&] {
      std::vector<double> all = copy(plain.data().qpos, plain.model().nq);
      all.insert(all.end(), plain.data().qvel, plain.data().qvel + plain.model().nv);
      return all;
    }());
  }
}

TEST(EnvStep, EpisodesAreCutAtTheirLimit) {
  env::EnvOptions options = without_renderer();
  options.max_steps = 3;
  const auto world = benchmark_world(blind(), options);
  for (int episode = 0; episode < 2; ++episode) {
    world->reset(nullptr, nullptr);
    for (int step = 1; step <= 4; ++step) {
      double reward = 7;
      std::uint8_t terminated = 7, truncated = 7;
      world->step({}, nullptr, {{&reward, 1}, {&terminated, 1}, {&truncated, 1}});
      EXPECT_EQ(reward, 0);
      EXPECT_EQ(terminated, 0);
      EXPECT_EQ(truncated, step >= 3 ? 1 : 0) << "step " << step;
    }
  }
}

TEST(EnvStep, SameSeedSameEpisode) {
  const auto world = benchmark_world();
  const std::uint64_t seed = 12345;
  const auto episode = [&] {
    world->reset(&seed, nullptr);
    for (int step = 0; step < 40; ++step) world->step(some_actions(*world, step), nullptr, {});
    return state(*world);
  };
  const std::vector<double> first = episode();
  EXPECT_EQ(episode(), first);
}

// A world that failed refuses everything but reset; the next episode is as if nothing had happened.
TEST(EnvStep, FailedWorld) {
  const auto fresh = benchmark_world();
  const auto world = benchmark_world();
  Observation block(*world);
  world->physics().data().qvel[0] = 1e300;
  expect_error(Status::kSimulation, "QVEL", [&] { world->step({}, block.data(), {}); });
  const Observation kept = block;
  expect_error(Status::kSimulation, "reset", [&] { world->step({}, block.data(), {}); });
  expect_error(Status::kSimulation, "reset", [&] { world->observe(block.data()); });
  expect_error(Status::kSimulation, "reset", [&] { world->physics().step(1); });
  EXPECT_EQ(block.bytes(), kept.bytes());
  Observation one(*fresh), two(*world);
  fresh->reset(nullptr, one.data());
  world->reset(nullptr, two.data());
  for (int step = 0; step < 40; ++step) {
    fresh->step(some_actions(*fresh, step), one.data(), {});
    world->step(some_actions(*world, step), two.data(), {});
    ASSERT_EQ(one.bytes(), two.bytes());
  }
}

// Gives the rewards 1, infinity, 1 ...
class Generous : public tasks::Task {
 public:
  Generous() : Task({{"gift", 0.0}}) {}
  void evaluate(const engine::Physics&) override {
    terms_[0].value = ++steps_ == 2 ? std::numeric_limits<double>::infinity() : 1.0;
    success_ = true;
  }

 private:
  int steps_ = 0;
};

// Whatever task it is: the step fails, and the world can be saved, loaded and stepped.
TEST(EnvStep, RewardsAreFinite) {
  env::EnvOptions options = without_renderer();
  options.custom_task = [](const env::Identity&, std::size_t) { return std::make_unique<Generous>(); };
  const auto world = benchmark_world(blind(), options);
  world->step({}, nullptr, {});
  try {
    world->step({}, nullptr, {});
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kTask);
    EXPECT_EQ(error.message(), "the task's function evaluate gave agent 0 the reward inf, expected a finite number");
  }
  EXPECT_EQ(world->agents()[0].task->reward(), 0);
  EXPECT_NE(world->agents()[0].task->outcome(), tasks::Outcome::kSuccess);
  std::vector<std::uint8_t> state(world->state_bytes());
  world->save({state.data(), state.size()});
  world->load({state.data(), state.size()});
  double reward = 0;
  world->step({}, nullptr, {{&reward, 1}, {}, {}});
  EXPECT_EQ(reward, 1);
}

// A full buffer is reported once an episode, and the world goes on.
TEST(EnvStep, WarningsReachTheLog) {
  // A box that lies on the floor with four corners.
  const std::string size = MIMO_MUJOCO_4 ? "memory='2K'" : "nconmax='2'";
  scene::Scene scene(from_text("<mujoco><size " + size +
                               "/><worldbody><geom type='plane' size='0 0 1'/><body pos='0 0 .099'><freejoint/><geom "
                               "type='box' size='.1 .1 .1'/></body></worldbody></mujoco>"));
  std::vector<LogRecord> heard;
  env::Services services;
  services.log = LogSink([&heard](const LogRecord& record) { heard.push_back(record); });
  env::World world(compile(scene), {}, without_renderer(), services, {0, 7, nullptr});
  ASSERT_FALSE(heard.empty());
  EXPECT_TRUE(contains(heard[0].text, MIMO_MUJOCO_4 ? "memory of <size>" : "nconmax"));
  EXPECT_EQ(heard[0].level, LogLevel::kWarning);
  EXPECT_EQ(heard[0].code, static_cast<int>(engine::Warning::kContactsDropped));
  EXPECT_TRUE(heard[0].in_world);
  EXPECT_EQ(heard[0].world, 7u);
  constexpr std::size_t kKinds = MIMO_MUJOCO_4 ? 2 : 1;  // one room for contacts and constraints there
  const auto dropped = [&heard] {
    const auto told = [](const LogRecord& r) { return r.code == static_cast<int>(engine::Warning::kContactsDropped); };
    return std::count_if(heard.begin(), heard.end(), told);
  };
  for (int step = 0; step < 5; ++step) world.step({}, nullptr, {});
  EXPECT_EQ(dropped(), 1);
  EXPECT_EQ(heard.size(), kKinds);
  world.reset(nullptr, nullptr);
  EXPECT_EQ(dropped(), 2);
  EXPECT_EQ(heard.size(), 2 * kKinds);
}

}  // namespace
}  // namespace mimo::test
