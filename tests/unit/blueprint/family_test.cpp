// Kits of all ages, each compiled once.
#include "blueprint/family.h"

#include "engine/compat.h"
#include "unit/blueprint/fixture.h"

namespace mimo::test {
namespace {

using blueprint::Family;

growth::Growth aged(double months) {
  growth::Growth growth;
  growth.age = growth.physiological_age = months;
  return growth;
}

Draft with_infant() {
  Blueprint blueprint(named("free"));
  blueprint.edit([](Draft& draft) { draft.add_agent(infant("")); });
  return blueprint.draft();
}

TEST(Family, CompilesAnAgeOnce) {
  Family family(with_infant(), without_renderer(), {});
  const env::KitPtr usual = family.as_described({}, {}), young = family.as_described({aged(6)}, {});
  EXPECT_NE(usual->model, young->model);
  EXPECT_EQ(young->agents[0].growth, aged(6));
  EXPECT_EQ(family.grown(*usual, {aged(6)}), young);
  EXPECT_EQ(family.grown(*young, {std::nullopt}), young);
  EXPECT_EQ(family.grown(*young, {aged(18)}), usual);
}

// Eight: one in use, one that nobody asks for any more, one that is asked for again and again, and others.
TEST(Family, KeepsTheLastOnesAndThoseInUse) {
  Family family(with_infant(), without_renderer(), {});
  const env::KitPtr used = family.as_described({aged(1)}, {});
  const std::weak_ptr<const env::Kit> idle = family.as_described({aged(2)}, {});
  const std::weak_ptr<const env::Kit> asked_for = family.as_described({aged(3)}, {});
  for (std::size_t members = 4; members <= Family::kKept + 1; ++members) {
    EXPECT_FALSE(idle.expired());
    family.as_described({aged(6 + static_cast<double>(members))}, {});
    family.as_described({aged(3)}, {});
  }
  EXPECT_TRUE(idle.expired());
  EXPECT_FALSE(asked_for.expired());
  EXPECT_EQ(family.as_described({aged(1)}, {}), used);
}

TEST(Family, HoldsTexturesOnce) {
  Family family(with_infant(), without_renderer(), {});
  const std::weak_ptr<const env::Kit> first = family.as_described({}, {});
  const env::KitPtr young = family.as_described({aged(6)}, {}), old = family.as_described({aged(24)}, {});
  EXPECT_GT(young->model->ntexdata, 1000000);
  EXPECT_EQ((*young->model).*engine::compat::kPixels, (*old->model).*engine::compat::kPixels);
  EXPECT_EQ((*young->model).*engine::compat::kPixels, (*first.lock()->model).*engine::compat::kPixels);
  EXPECT_EQ(young->services.textures, old->services.textures);
}

TEST(Family, OfAWorldCompilesTheSameModelAsTheBlueprint) {
  Blueprint blueprint(named("free"));
  AgentPlan young = infant("");
  young.growth = aged(6);
  blueprint.edit([&](Draft& draft) { draft.add_agent(young); });
  Family family(with_infant(), without_renderer(), {});
  const env::KitPtr ours = family.as_described({aged(6)}, {}), theirs = blueprint.compile(without_renderer(), {});
  env::World grown(ours->model, ours->agents, ours->options, ours->services);
  env::World made(theirs->model, theirs->agents, theirs->options, theirs->services);
  EXPECT_EQ(step(grown, 1), step(made, 1));
  EXPECT_EQ(saved(grown), saved(made));
}

}  // namespace
}  // namespace mimo::test
