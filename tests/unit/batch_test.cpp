#include "batch/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "batch/threads.h"
#include "common/cores.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using batch::Autoreset;
using batch::Batch;

// A batch with room for everything that it can give, and what a learner does with it.
class Rig {
 public:
  Rig(const engine::ModelPtr& model, const batch::Options& options, const env::EnvOptions& world_options = {},
      const LogSink& log = {}, const env::AgentOptions& agent = blind())
      : batch(compiled_worlds_of({model, {agent}, world_options, {nullptr, nullptr, nullptr, nullptr, log}}), options),
        block_bytes(batch.world(0).layout().bytes()),
        blocks(options.worlds * block_bytes),
        final_blocks(blocks.size()),
        reward(options.worlds),
        terminated(options.worlds),
        truncated(options.worlds),
        was_reset(options.worlds),
        final_written(options.worlds),
        status(options.worlds) {
    std::vector<std::uint64_t> seeds(options.worlds);
    std::iota(seeds.begin(), seeds.end(), 100);
    batch.reset(seeds.data(), nullptr, blocks.data());
  }

  batch::Output output() {
    std::fill(blocks.begin(), blocks.end(), 0xbb);
    std::fill(final_blocks.begin(), final_blocks.end(), 0xff);
    return {blocks.data(), reward.data(), terminated.data(), truncated.data(),    nullptr,
            nullptr,       status.data(), was_reset.data(),  final_blocks.data(), final_written.data()};
  }

  std::vector<float> actions(int number) const {
    std::vector<float> all;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const auto own = some_actions(batch.world(0).action_size(), number + 1000 * static_cast<int>(i));
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }

  void step(int number) { batch.step(actions(number).data(), output()); }

  Bytes block(std::size_t world) const { return row(blocks, world); }
  Bytes final_block(std::size_t world) const { return row(final_blocks, world); }

  Batch batch;
  std::size_t block_bytes;
  Bytes blocks, final_blocks;
  std::vector<double> reward;
  std::vector<std::uint8_t> terminated, truncated, was_reset, final_written;
  std::vector<std::int32_t> status;

 private:
  Bytes row(const Bytes& from, std::size_t world) const {
    const auto start = from.begin() + static_cast<std::ptrdiff_t>(world * block_bytes);
    return {start, start + static_cast<std::ptrdiff_t>(block_bytes)};
  }
};

batch::Options sized(std::size_t worlds, std::size_t threads, Autoreset autoreset = Autoreset::kNone) {
  batch::Options options;
  options.worlds = worlds;
  options.threads = threads;
  options.autoreset = autoreset;
  return options;
}

env::EnvOptions lasting(std::uint32_t steps) {
  env::EnvOptions options;
  options.max_steps = steps;
  return options;
}

// The single world that world i of a Rig has to equal.
std::unique_ptr<env::World> single(const engine::ModelPtr& model, std::size_t i, const env::EnvOptions& options = {}) {
  auto world = make_world(model, options);
  const std::uint64_t seed = 100 + i;
  world->reset(&seed, nullptr);
  return world;
}

int number_for(std::size_t world, int number) { return number + 1000 * static_cast<int>(world); }

bool is_all(const Bytes& bytes, std::uint8_t value) {
  return std::all_of(bytes.begin(), bytes.end(), [=](std::uint8_t byte) { return byte == value; });
}

void break_world(env::World& world) { world.physics().data().qvel[0] = 1e300; }

std::string failure(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

void expect_equal_single_worlds(const env::AgentOptions& agent) {
  const engine::ModelPtr model = room_with_infant("reach");
  constexpr std::size_t kWorlds = 5;
  std::vector<std::unique_ptr<env::World>> singles;
  std::vector<std::unique_ptr<Rig>> rigs;
  for (std::uint64_t i = 0; i < kWorlds; ++i) {
    const std::uint64_t seed = 100 + i;
    singles.push_back(std::make_unique<env::World>(model, std::vector<env::AgentOptions>{agent}, env::EnvOptions{}));
    singles.back()->reset(&seed, nullptr);
  }
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    rigs.push_back(std::make_unique<Rig>(model, sized(kWorlds, threads), env::EnvOptions{}, LogSink{}, agent));
  }
  for (int n = 0; n < 40; ++n) {
    for (const auto& rig : rigs) rig->step(n);
    for (std::size_t i = 0; i < kWorlds; ++i) {
      const Bytes expected = step(*singles[i], number_for(i, n));
      for (const auto& rig : rigs) ASSERT_EQ(rig->block(i), expected) << "step " << n << ", world " << i;
    }
  }
  for (std::size_t i = 0; i < kWorlds; ++i) {
    for (const auto& rig : rigs) EXPECT_EQ(saved(rig->batch.world(i)), saved(*singles[i]));
  }
}

TEST(Batch, EqualsSingleWorldsForAnyNumberOfThreads) { expect_equal_single_worlds(blind()); }

// Both remember something from step to step.
TEST(Batch, OfMusclesAndLimitedSensesEqualsSingleWorlds) {
  env::AgentOptions agent = blind();
  agent.actuation.mode = actuation::Mode::kMuscle;
  agent.limits = {{"proprioception", {0.9, 0.05, 0, 4}}};
  expect_equal_single_worlds(agent);
}

TEST(Batch, SendAndReceiveAreAStep) {
  Rig sent(floating_model(), sized(6, 2)), stepped(floating_model(), sized(6, 2));
  for (int n = 0; n < 20; ++n) {
    stepped.step(n);
    const std::vector<float> actions = sent.actions(n);
    sent.batch.send(actions.data(), sent.output());
    EXPECT_NE(failure([&] { sent.batch.step(actions.data(), {}); }), "");
    EXPECT_NE(failure([&] { sent.batch.reset(nullptr, nullptr, nullptr); }), "");
    EXPECT_NE(failure([&] { sent.batch.require_access(0); }), "");
    sent.batch.receive();
    ASSERT_EQ(sent.blocks, stepped.blocks) << "step " << n;
  }
  EXPECT_NE(failure([&] { sent.batch.receive(); }), "");
  sent.batch.require_access(0);
}

// Blocks and actions are the caller's, and must outlive what was sent.
TEST(Batch, CanBeDestroyedAtWork) {
  Bytes blocks;
  std::vector<float> actions;
  Batch batch(compiled_worlds_of({floating_model(), {blind()}, {}, {}}), sized(6, 2));
  blocks.resize(6 * batch.world(0).layout().bytes());
  actions.resize(6 * batch.world(0).action_size());
  batch.reset(nullptr, nullptr, nullptr);
  batch::Output output;
  output.blocks = blocks.data();
  batch.send(actions.data(), output);
}

TEST(Batch, ADivergingWorldStopsNoOther) {
  Rig rig(floating_model(), sized(4, 2));
  const auto other = single(floating_model(), 3);
  break_world(rig.batch.world(1));
  const std::string message = failure([&] { rig.step(0); });
  EXPECT_EQ(message.rfind("world 1: the simulation failed", 0), 0u) << message;
  EXPECT_EQ(rig.status, (std::vector<std::int32_t>{0, -7, 0, 0}));
  EXPECT_EQ(rig.batch.report(1).message.rfind("the simulation failed", 0), 0u);
  EXPECT_TRUE(is_all(rig.block(1), 0));
  EXPECT_EQ(rig.truncated, (std::vector<std::uint8_t>{0, 1, 0, 0}));
  EXPECT_EQ(rig.block(3), step(*other, number_for(3, 0)));

  // It stays failed, and its first message stays too, until it is reset.
  EXPECT_EQ(failure([&] { rig.step(1); }), message);
  EXPECT_EQ(rig.status[1], -7);
  EXPECT_EQ(rig.block(3), step(*other, number_for(3, 1)));
  const std::uint8_t mask[] = {0, 1, 0, 0};
  rig.batch.reset(nullptr, mask, nullptr);
  EXPECT_EQ(rig.batch.report(1).status, Status::kOk);
  rig.step(2);
  EXPECT_EQ(rig.status, (std::vector<std::int32_t>(4, 0)));
  EXPECT_EQ(rig.block(3), step(*other, number_for(3, 2)));
}

TEST(Batch, CountsTheFailures) {
  Rig rig(floating_model(), sized(3, 1));
  break_world(rig.batch.world(1));
  break_world(rig.batch.world(2));
  EXPECT_EQ(failure([&] { rig.step(0); }).rfind("world 1 (and 1 more): ", 0), 0u);
}

TEST(Batch, RestartsADivergingWorldAsConfigured) {
  for (const Autoreset mode : {Autoreset::kNone, Autoreset::kNextStep, Autoreset::kSameStep}) {
    batch::Options options = sized(3, 2, mode);
    options.restart_failed = true;
    Rig rig(floating_model(), options);
    const auto twin = single(floating_model(), 1);
    Bytes first(rig.block_bytes);
    twin->reset(nullptr, first.data());
    break_world(rig.batch.world(1));
    rig.step(0);  // does not throw: it is settled
    EXPECT_EQ(rig.status, (std::vector<std::int32_t>{0, -7, 0}));
    EXPECT_NE(rig.batch.report(1).message, "");
    EXPECT_EQ(rig.truncated[1], 1);
    if (mode == Autoreset::kNextStep) {
      EXPECT_TRUE(is_all(rig.block(1), 0));
      EXPECT_EQ(rig.was_reset[1], 0);
      rig.step(1);
      EXPECT_EQ(rig.truncated[1], 0);
      EXPECT_EQ(rig.status[1], 0);
    }
    EXPECT_EQ(rig.was_reset, (std::vector<std::uint8_t>{0, 1, 0}));
    EXPECT_EQ(rig.final_written[1], 0);
    EXPECT_EQ(rig.block(1), first);
    rig.step(5);
    EXPECT_EQ(rig.status[1], 0);
    EXPECT_EQ(rig.block(1), step(*twin, number_for(1, 5)));
  }
}

TEST(Batch, ANaNConcernsItsWorldAlone) {
  Rig rig(floating_model(), sized(3, 2));
  const auto other = single(floating_model(), 2);
  const Bytes before = saved(rig.batch.world(1));
  std::vector<float> actions = rig.actions(0);
  actions[rig.batch.world(0).action_size() + 4] = std::numeric_limits<float>::quiet_NaN();
  rig.reward[1] = 77;
  EXPECT_EQ(failure([&] { rig.batch.step(actions.data(), rig.output()); }), "world 1: action[4] is not a number");
  EXPECT_EQ(rig.status, (std::vector<std::int32_t>{0, -1, 0}));
  EXPECT_EQ(saved(rig.batch.world(1)), before);
  EXPECT_TRUE(is_all(rig.block(1), 0xbb));
  EXPECT_EQ(rig.reward[1], 77);
  EXPECT_EQ(rig.block(2), step(*other, number_for(2, 0)));
  rig.step(1);
  EXPECT_EQ(rig.status[1], 0);
}

TEST(Batch, WithoutAutoresetWorldsGoOn) {
  Rig rig(floating_model(), sized(2, 2), lasting(3));
  const auto twin = single(floating_model(), 1, lasting(3));
  for (int n = 0; n < 6; ++n) {
    rig.step(n);
    EXPECT_EQ(rig.truncated[1], n >= 2);
    EXPECT_EQ(rig.was_reset[1], 0);
    EXPECT_EQ(rig.block(1), step(*twin, number_for(1, n)));
  }
}

TEST(Batch, ResetsWithTheNextStep) {
  Rig rig(floating_model(), sized(2, 2, Autoreset::kNextStep), lasting(3));
  const auto twin = single(floating_model(), 1, lasting(3));
  for (int n = 0; n < 12; ++n) {
    rig.step(n);
    const bool starts = n % 4 == 3;
    EXPECT_EQ(rig.was_reset[1], starts);
    EXPECT_EQ(rig.truncated[1], n % 4 == 2);
    EXPECT_EQ(rig.final_written[1], 0);
    Bytes expected(rig.block_bytes);
    if (starts) {
      twin->reset(nullptr, expected.data());
    } else {
      expected = step(*twin, number_for(1, n));
    }
    ASSERT_EQ(rig.block(1), expected) << "step " << n;
  }
}

TEST(Batch, ResetsInTheSameStep) {
  Rig rig(floating_model(), sized(2, 2, Autoreset::kSameStep), lasting(3));
  const auto twin = single(floating_model(), 1, lasting(3));
  for (int n = 0; n < 9; ++n) {
    rig.step(n);
    const bool ends = n % 3 == 2;
    Bytes expected = step(*twin, number_for(1, n));
    EXPECT_EQ(rig.truncated[1], ends);
    EXPECT_EQ(rig.was_reset[1], ends);
    EXPECT_EQ(rig.final_written[1], ends);
    if (ends) {
      EXPECT_EQ(rig.final_block(1), expected);
      twin->reset(nullptr, expected.data());
    } else {
      EXPECT_TRUE(is_all(rig.final_block(1), 0xff));
    }
    ASSERT_EQ(rig.block(1), expected) << "step " << n;
  }
}

// Ends the episode of agent 0 after two steps.
class Ending : public tasks::Task {
 public:
  explicit Ending(bool ends) : Task({{"steps", 0.0}}) { ends_ = ends; }
  void reset(engine::Physics&, Random&) override { steps_ = 0; }
  void evaluate(const engine::Physics&) override {
    terms_[0].value = ++steps_;
    success_ = steps_ == 2;
  }

 private:
  int steps_ = 0;
};

TEST(Batch, AnAgentThatIsCutOffByAnothersEndIsTruncated) {
  scene::Scene scene(named("free"));
  const document::Pose left{{0, 2, 1}, {1, 0, 0, 0}}, right{{0, -2, 1}, {1, 0, 0, 0}};
  scene.add_body("mitten", "anna/", &left);
  scene.add_body("mitten", "ben/", &right);
  std::vector<env::AgentOptions> agents(2, blind());
  agents[0].name = "anna";
  agents[1].name = "ben";
  env::EnvOptions world;
  world.custom_task = [](const env::Identity&, std::size_t agent) { return std::make_unique<Ending>(agent == 0); };
  Batch two(compiled_worlds_of({compile(scene), agents, world, {}}), sized(2, 2, Autoreset::kNextStep));
  two.reset(nullptr, nullptr, nullptr);
  std::vector<std::uint8_t> terminated(4), truncated(4);
  batch::Output output;
  output.terminated = terminated.data();
  output.truncated = truncated.data();
  two.step(nullptr, output);
  EXPECT_EQ(truncated, (std::vector<std::uint8_t>{0, 0, 0, 0}));
  two.step(nullptr, output);
  EXPECT_EQ(terminated, (std::vector<std::uint8_t>{1, 0, 1, 0}));
  EXPECT_EQ(truncated, (std::vector<std::uint8_t>{0, 1, 0, 1}));
}

TEST(Batch, MasksLeaveTheOthersAlone) {
  Rig rig(floating_model(), sized(3, 2));
  rig.step(0);
  const std::uint8_t mask[] = {0, 1, 0};
  const Bytes before = saved(rig.batch.world(0));
  std::fill(rig.blocks.begin(), rig.blocks.end(), 0xbb);
  const std::uint64_t seeds[] = {5, 6, 7};
  rig.batch.reset(seeds, mask, rig.blocks.data());
  const auto twin = make_world(floating_model());
  Bytes first(rig.block_bytes);
  twin->reset(&seeds[1], first.data());
  EXPECT_EQ(rig.block(1), first);
  EXPECT_TRUE(is_all(rig.block(0), 0xbb));
  EXPECT_TRUE(is_all(rig.block(2), 0xbb));
  EXPECT_EQ(saved(rig.batch.world(0)), before);

  std::fill(rig.blocks.begin(), rig.blocks.end(), 0xbb);
  rig.batch.observe(mask, rig.blocks.data());
  EXPECT_EQ(rig.block(1), first);
  EXPECT_TRUE(is_all(rig.block(2), 0xbb));
}

TEST(Batch, NamedAccessStacksTheWorlds) {
  Rig rig(floating_model(), sized(3, 2));
  for (int n = 0; n < 5; ++n) rig.step(n);
  const std::vector<std::int32_t> ids = {4, 1};
  const access::Ids which{Span<const std::int32_t>(ids)};
  const access::Quantity& quantity = access::quantity_of(MIMO_JOINT_POSITION);
  std::vector<double> values(6), own(2);
  rig.batch.get(quantity, which, false, nullptr, values.data());
  for (std::size_t i = 0; i < 3; ++i) {
    access::get(rig.batch.world(i), quantity, which, false, Span<double>(own));
    EXPECT_EQ(own[0], values[2 * i]);
    EXPECT_EQ(own[1], values[2 * i + 1]);
  }
  const std::uint8_t mask[] = {1, 0, 1};
  const Bytes before = saved(rig.batch.world(1));
  const std::vector<double> wanted = {.1, .2, .3, .4, .5, .6};
  rig.batch.set(quantity, which, mask, wanted.data());
  std::vector<double> back(6, -1);
  rig.batch.get(quantity, which, false, mask, back.data());
  EXPECT_EQ(back, (std::vector<double>{.1, .2, -1, -1, .5, .6}));
  EXPECT_EQ(saved(rig.batch.world(1)), before);

  std::vector<double> bad = wanted;
  bad[4] = HUGE_VAL;
  const Bytes first = saved(rig.batch.world(0));
  EXPECT_NE(failure([&] { rig.batch.set(quantity, which, nullptr, bad.data()); }), "");
  EXPECT_EQ(saved(rig.batch.world(0)), first);  // all were checked before any was changed
}

TEST(Batch, SavesAndLoadsManyStates) {
  Rig rig(floating_model(), sized(3, 2, Autoreset::kNextStep), lasting(4));
  for (int n = 0; n < 4; ++n) rig.step(n);  // the next step starts new episodes
  const std::size_t bytes = rig.batch.world(0).state_bytes();
  Bytes states(3 * bytes);
  rig.batch.save(nullptr, states.data());
  rig.step(4);
  const Bytes blocks = rig.blocks;
  EXPECT_EQ(rig.was_reset[2], 1);
  rig.step(5);
  rig.batch.load(nullptr, Span<const std::uint8_t>(states));
  rig.step(4);
  EXPECT_EQ(rig.blocks, blocks);

  const auto present = single(floating_model(), 9, lasting(4));
  const Bytes state = saved(*present);
  rig.batch.load(nullptr, Span<const std::uint8_t>(state));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(saved(rig.batch.world(i)), state);

  EXPECT_EQ(failure([&] {
              rig.batch.load(nullptr, {states.data(), 3 * bytes - 1});
            }),
            "state_bytes is " + std::to_string(3 * bytes - 1) + ", expected " + std::to_string(3 * bytes) +
                " (3 worlds x " + std::to_string(bytes) + "), or a single state of its own size");

  states[bytes + 100] ^= 1;
  EXPECT_EQ(failure([&] { rig.batch.load(nullptr, Span<const std::uint8_t>(states)); }),
            "world 1: state: it is damaged, its checksum is wrong");
  // All rows were checked before any world changed: the worlds before and after the damaged row have kept their states.
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(saved(rig.batch.world(i)), state);
}

TEST(Batch, HasAThreadForEachCoreThatItMayUse) {
  const auto threads = [] {
    return Batch(compiled_worlds_of({room_with_infant("free"), {blind()}, {}, {}}), sized(2, 0)).threads();
  };
  EXPECT_EQ(threads(), std::min<std::size_t>(2, usable_cores()));
#if defined(__linux__)
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  int core = 0;
  while (!CPU_ISSET(core, &before)) ++core;
  CPU_ZERO(&one);
  CPU_SET(core, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  const std::size_t alone = threads();
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(alone, 1u);
#endif
}

// Worlds 0 and 2 are of one model, world 1 of another.
TEST(Batch, WorldsOfOneModelShareItAndTheirSkin) {
  const auto compiled = [](const engine::ModelPtr& model) {
    env::Services services;
    services.skins = std::make_shared<env::Skins>();
    return std::make_shared<const env::CompiledWorld>(
        env::CompiledWorld{model, {blind()}, without_renderer(), services});
  };
  const Batch batch({compiled(room_with_infant("free")), compiled(room_with_infant("free"))}, sized(4, 2));
  const auto shape = [&](std::size_t i) { return batch.world(i).model().geom_size; };
  const auto skin = [&](std::size_t i) { return batch.world(i).agents()[0].skin; };
  EXPECT_EQ(shape(0), shape(2));
  EXPECT_NE(shape(0), shape(1));
  EXPECT_EQ(skin(0), skin(2));
  EXPECT_NE(skin(0), skin(1));
}

TEST(Batch, WorldsThatObserveSomethingElseAreRefused) {
  env::AgentOptions coarse = blind(), silent = blind();
  coarse.touch.everywhere = 0.1;
  silent.vestibular.wanted = 0;
  const auto with = [](const env::AgentOptions& agent) {
    return compiled_worlds_of({floating_model(), {agent}, without_renderer(), {}})[0];
  };
  const env::CompiledWorldPtr usual = with(blind());
  const auto refusal = [&](const env::AgentOptions& agent) {
    return failure([&] { Batch({usual, usual, with(agent)}, sized(3, 1)); });
  };
  EXPECT_EQ(refusal(coarse).rfind("world 2: field \"touch/force\" has shape ", 0), 0u) << refusal(coarse);
  EXPECT_EQ(refusal(silent).rfind("world 2: there are ", 0), 0u) << refusal(silent);

  Batch batch({usual}, sized(3, 1));
  step(batch.world(1), 1);
  const Bytes before = saved(batch.world(1));
  EXPECT_EQ(failure([&] {
              batch.reset(nullptr, nullptr, nullptr, {nullptr, with(coarse), usual});
            }).rfind("world 1: field \"touch/force\"", 0),
            0u);
  EXPECT_NE(failure([&] { batch.aging(1).reset_as(with(silent), nullptr, nullptr); }), "");
  EXPECT_EQ(saved(batch.world(1)), before);
  EXPECT_EQ(batch.aging(1).compiled(), usual);
}

TEST(Batch, UnseededWorldsDiffer) {
  Batch all(compiled_worlds_of({room_with_infant("reach"), {blind()}, {}, {}}), sized(2, 1));
  all.reset(nullptr, nullptr, nullptr);
  EXPECT_NE(saved(all.world(0)), saved(all.world(1)));
}

TEST(Batch, MessagesArriveOnTheCallingThread) {
  std::vector<LogRecord> heard;
  bool elsewhere = false;
  const LogSink log([&](const LogRecord& record) {
    heard.push_back(record);
    elsewhere = elsewhere || batch::current_thread().batch != nullptr;
  });
  Rig rig(floating_model(), sized(4, 3), {}, log);
  for (std::size_t i : {1, 2}) rig.batch.world(i).physics().data().warning[mjWARN_CONTACTFULL].number = 1;
  rig.step(0);
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(heard[0].world, 1u);
  EXPECT_EQ(heard[1].world, 2u);
  EXPECT_DOUBLE_EQ(heard[0].time, rig.batch.world(1).data().time);
  EXPECT_FALSE(elsewhere);
}

TEST(Batch, Of64Worlds) {
  Rig rig(benchmark_model(), sized(64, 2, Autoreset::kSameStep), lasting(10));
  const auto twin = single(benchmark_model(), 63, lasting(10));
  for (int n = 0; n < 12; ++n) {
    rig.step(n);
    Bytes expected = step(*twin, number_for(63, n));
    if (n == 9) twin->reset(nullptr, expected.data());
    ASSERT_EQ(rig.block(63), expected) << "step " << n;
  }
}

}  // namespace
}  // namespace mimo::test
