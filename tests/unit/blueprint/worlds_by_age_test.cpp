// Kits of all ages, each compiled once.
#include "blueprint/worlds_by_age.h"

#include "compat/mujoco.h"
#include "unit/blueprint/fixture.h"

namespace mimo::test {
namespace {

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

}  // namespace
}  // namespace mimo::test
