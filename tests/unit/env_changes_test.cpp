// How a world tells that something else than a step has changed it: by a number that a recorder compares.
#include <gtest/gtest.h>

#include "access/access.h"
#include "env/state.h"
#include "env/world.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

// What was done is told exactly where the world's state has become another one.
template <typename Deed>
void expect_told(env::World& world, const char* what, Deed&& deed) {
  const Bytes before = saved(world);
  const std::uint64_t changes = world.changes();
  deed();
  EXPECT_EQ(world.changes() != changes, saved(world) != before) << what;
}

void set(env::World& world, mimo_quantity quantity, int id, std::initializer_list<double> values) {
  const std::vector<double> all(values);
  const std::int32_t ids[] = {id};
  access::set(world, access::quantity_of(quantity), access::Ids(Span<const std::int32_t>(ids, 1)),
              Span<const double>(all));
}

TEST(Changes, CountChangesOfEverythingInAState) {
  const auto world = benchmark_world();
  step(*world, 1);
  const Bytes before = saved(*world);
  const std::uint64_t seed = 5;
  const std::vector<double> still(world->data().qpos, world->data().qpos + world->model().nq);
  expect_told(*world, "joint", [&] { set(*world, MIMO_JOINT_POSITION, 3, {0.1}); });
  expect_told(*world, "gravity", [&] { set(*world, MIMO_WORLD_GRAVITY, 0, {0, 0, -1}); });
  expect_told(*world, "colour", [&] { set(*world, MIMO_GEOM_COLOR, 0, {1, 0, 0, 1}); });
  expect_told(*world, "face", [&] { set(*world, MIMO_AGENT_FACE, 0, {1}); });
  expect_told(*world, "look", [&] { env::look_at(*world, 0, {1, 0.2, 0.5}, true); });
  expect_told(*world, "physics", [&] { world->step_physics(2); });
  expect_told(*world, "random", [&] { world->random().next(); });
  expect_told(*world, "load", [&] { load(*world, before); });
  expect_told(*world, "reset", [&] { world->reset(&seed, nullptr); });
  std::vector<double> movement;
  for (int i = 0; i < world->frame_skip(); ++i) movement.insert(movement.end(), still.begin(), still.end());
  expect_told(*world, "follow", [&] { world->follow(Span<const double>(movement), {}, nullptr); });
}

TEST(Changes, DoNotCountReads) {
  const auto world = benchmark_world();
  step(*world, 1);
  const std::uint64_t changes = world->changes();
  Bytes block(world->layout().bytes());
  world->observe(block.data());
  world->update_poses();
  env::look(*world, 0, {1, 0.2, 0.5}, true);
  saved(*world);
  step(*world, 2);
  EXPECT_THROW(set(*world, MIMO_JOINT_POSITION, 3, {std::numeric_limits<double>::infinity()}), Error);
  EXPECT_EQ(world->changes(), changes);
}

// A task of the user's own may fail once the step has happened.
TEST(Changes, CountFailedSteps) {
  class Failing : public tasks::Task {
   public:
    Failing() : Task({}) {}
    void reset(engine::Physics&, Random&) override {}
    void evaluate(const engine::Physics&) override { fail(Status::kTask, "it fails"); }
  };
  env::EnvOptions options = without_renderer();
  options.custom_task = [](const env::Identity&, std::size_t) { return std::make_unique<Failing>(); };
  const auto world = benchmark_world(blind(), options);
  class Following : public env::StepObserver {
   public:
    std::uint8_t* step_begins(const env::World&, std::uint8_t* block) noexcept override { return block; }
    std::uint8_t* movement_begins(const env::World&, std::uint8_t* block) noexcept override { return block; }
    void step_ends(env::World&, Span<const float>, const std::uint8_t*) noexcept override {}
    void step_failed() noexcept override {}
    void goes_on_in(env::World&) noexcept override {}
    void ends(const env::World&) noexcept override {}
  };
  world->tell(std::make_shared<Following>());
  const std::uint64_t changes = world->changes();
  EXPECT_THROW(step(*world, 1), Error);
  EXPECT_NE(world->changes(), changes);
}

}  // namespace
}  // namespace mimo::test
