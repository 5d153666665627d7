// Models of all ages, each compiled once, and worlds whose infants become older or younger.

#include "blueprint/aging_world.h"

#include "compat/mujoco.h"
#include "engine/model.h"
#include "unit/blueprint/fixture.h"

namespace mimo::test {
namespace {

using blueprint::AgingWorld;
using blueprint::WorldsByAge;

growth::Growth aged(double months) {
  growth::Growth growth;
  growth.age = growth.physiological_age = months;
  return growth;
}

SceneEdit with_infant() {
  Blueprint blueprint(named("free"));
  blueprint.edit([](SceneEdit& edit) { edit.add_agent(infant("")); });
  return blueprint.current();
}

TEST(WorldsByAge, CompilesAnAgeOnce) {
  WorldsByAge worlds(with_infant(), without_renderer(), {});
  const env::CompiledWorldPtr usual = worlds.as_described({}, {}), young = worlds.as_described({aged(6)}, {});
  EXPECT_NE(usual->model, young->model);
  EXPECT_EQ(young->agents[0].growth, aged(6));
  EXPECT_EQ(worlds.grown(*usual, {aged(6)}), young);
  EXPECT_EQ(worlds.grown(*young, {std::nullopt}), young);
  EXPECT_EQ(worlds.grown(*young, {aged(18)}), usual);
}

// Eight: one in use, one that nobody asks for any more, one that is asked for again and again, and others.
TEST(WorldsByAge, KeepsTheLastOnesAndThoseInUse) {
  WorldsByAge worlds(with_infant(), without_renderer(), {});
  const env::CompiledWorldPtr used = worlds.as_described({aged(1)}, {});
  const std::weak_ptr<const env::CompiledWorld> idle = worlds.as_described({aged(2)}, {});
  const std::weak_ptr<const env::CompiledWorld> asked_for = worlds.as_described({aged(3)}, {});
  for (std::size_t members = 4; members <= WorldsByAge::kKept + 1; ++members) {
    EXPECT_FALSE(idle.expired());
    worlds.as_described({aged(6 + static_cast<double>(members))}, {});
    worlds.as_described({aged(3)}, {});
  }
  EXPECT_TRUE(idle.expired());
  EXPECT_FALSE(asked_for.expired());
  EXPECT_EQ(worlds.as_described({aged(1)}, {}), used);
}

TEST(WorldsByAge, HoldsTexturesOnce) {
  WorldsByAge worlds(with_infant(), without_renderer(), {});
  const std::weak_ptr<const env::CompiledWorld> first = worlds.as_described({}, {});
  const env::CompiledWorldPtr young = worlds.as_described({aged(6)}, {}), old = worlds.as_described({aged(24)}, {});
  EXPECT_GT(young->model->ntexdata, 1000000);
  EXPECT_EQ((*young->model).*compat::kPixels, (*old->model).*compat::kPixels);
  EXPECT_EQ((*young->model).*compat::kPixels, (*first.lock()->model).*compat::kPixels);
  EXPECT_EQ(young->services.textures, old->services.textures);
}

TEST(WorldsByAge, OfAWorldCompilesTheSameModelAsTheBlueprint) {
  Blueprint blueprint(named("free"));
  AgentPlan young = infant("");
  young.growth = aged(6);
  blueprint.edit([&](SceneEdit& edit) { edit.add_agent(young); });
  WorldsByAge worlds(with_infant(), without_renderer(), {});
  const env::CompiledWorldPtr ours = worlds.as_described({aged(6)}, {}),
                              theirs = blueprint.compile(without_renderer(), {});
  env::World grown(ours->model, ours->agents, ours->options, ours->services);
  env::World made(theirs->model, theirs->agents, theirs->options, theirs->services);
  EXPECT_EQ(step(grown, 1), step(made, 1));
  EXPECT_EQ(saved(grown), saved(made));
}

AgingWorld aging_world() {
  Blueprint blueprint(named("free"));
  blueprint.edit([](SceneEdit& edit) { edit.add_agent(infant("")); });
  const auto worlds = std::make_shared<WorldsByAge>(blueprint.current(), without_renderer(), LogSink{});
  return {worlds, worlds->as_described({}, {}), {}};
}

double height(const AgingWorld& aging) { return aging.world().agents()[0].height; }

// A child of two years is taller than one of half a year by 20 cm: WHO, 86 and 66 cm in the mean of girls and boys.
TEST(AgingWorld, GoesOnInABodyOfAnotherAge) {
  AgingWorld aging = aging_world();
  const std::uint64_t seed = 7;
  aging.world().reset(&seed, nullptr);
  aging.world().physics().set_gravity({0, 0, -1.6});
  const env::CompiledWorldPtr usual = aging.compiled();
  aging.reset({aged(24)}, nullptr, nullptr);
  const double older = height(aging);
  aging.reset({aged(6)}, nullptr, nullptr);
  EXPECT_NEAR(older - height(aging), 0.2, 0.03);
  EXPECT_EQ(std::as_const(aging.world()).physics().gravity().z(), -1.6);
  aging.grow({aged(6)});  // as it is
  const std::uint64_t changes = aging.world().changes();
  aging.grow({aged(6)});
  EXPECT_EQ(aging.world().changes(), changes);
  aging.grow({growth::Growth()});
  EXPECT_EQ(aging.compiled(), usual);
}

TEST(AgingWorld, StaysAsItIsWhereTheOtherWorldObservesSomethingElse) {
  AgingWorld aging = aging_world();
  const auto before = saved(aging.world());
  Blueprint other(named("free"));
  other.edit([](SceneEdit& edit) {
    AgentPlan plan = infant("");
    plan.options.vestibular = {};
    plan.options.touch = {};
    plan.options.touch.everywhere = 0.1;
    edit.add_agent(plan);
  });
  const env::CompiledWorldPtr strange = other.compile(without_renderer(), {});
  EXPECT_THROW(aging.reset_as(strange, nullptr, nullptr), Error);
  EXPECT_NE(aging.compiled(), strange);
  EXPECT_EQ(saved(aging.world()), before);
}

TEST(AgingWorld, ACopyPlaysOnAndSharesTheSkin) {
  AgingWorld aging = aging_world();
  for (int i = 0; i < 3; ++i) step(aging.world(), i);
  const AgingWorld twin(aging, {});
  EXPECT_EQ(twin.world().agents()[0].skin, aging.world().agents()[0].skin);
  EXPECT_EQ(step(twin.world(), 3), step(aging.world(), 3));
  EXPECT_EQ(saved(twin.world()), saved(aging.world()));
}

}  // namespace
}  // namespace mimo::test
