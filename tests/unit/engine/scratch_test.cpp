// Memory that worlds need only while they are stepped is not their own.
#include "engine/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "compat/mujoco.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

#if !MIMO_MUJOCO_4

constexpr unsigned char kUntouched = 0x5a;

// A world's own stack and Jacobian, filled with bytes that no step writes.
class Own {
 public:
  explicit Own(engine::Physics& physics) : data_(physics.data()), stack_(data_.stack), jacobian_(data_.efc_J) {
    const mjModel& model = physics.model();
    const auto stack = reinterpret_cast<unsigned char*>(data_.stack);
    all_.emplace_back(stack, stack + sizeof(mjtNum) * static_cast<std::size_t>(data_.nstack));
    const auto first = reinterpret_cast<unsigned char*>(data_.efc_J_colind);
    const auto end = reinterpret_cast<unsigned char*>(data_.efc_JT + model.njmax * model.nv);
    all_.emplace_back(first, end);
    for (const auto& [begin, stop] : all_) std::fill(begin, stop, kUntouched);
  }

  bool are_untouched() const {
    return std::all_of(all_.begin(), all_.end(), [](const auto& each) {
      return std::all_of(each.first, each.second, [](unsigned char byte) { return byte == kUntouched; });
    });
  }
  bool are_in_place() const { return data_.stack == stack_ && data_.efc_J == jacobian_ && data_.pstack == 0; }

 private:
  mjData& data_;
  const mjtNum *stack_, *jacobian_;
  std::vector<std::pair<unsigned char*, unsigned char*>> all_;
};

std::string sparse_pile(const std::string& extra) { return pile(16, "<option jacobian='sparse'/>" + extra); }

TEST(Scratch, StepsLeaveAWorldsOwnStackAndJacobianUntouched) {
  const engine::ModelPtr model = compiled(sparse_pile(""));
  engine::Physics usual(model, {}), filled(model, {});
  const Own own(filled);
  EXPECT_EQ(trajectory(filled, 100), trajectory(usual, 100));
  ASSERT_GT(filled.data().nefc, 0);
  EXPECT_TRUE(own.are_in_place());
  filled.forward();
  filled.update_contacts();
  EXPECT_TRUE(own.are_untouched());
  EXPECT_TRUE(own.are_in_place());
}

TEST(Scratch, IsGivenBackAfterAnError) {
  engine::Physics physics(compiled(sparse_pile("<size nstack='3000'/>")), {});
  const Own own(physics);
  expect_error(Status::kSimulation, "tack overflow", [&] { physics.step(400); });
  EXPECT_TRUE(own.are_in_place());
  EXPECT_TRUE(own.are_untouched());
}

// What one leaves there is nothing to another, larger or smaller.
TEST(Scratch, ServesWorldsOfAllSizesInTurn) {
  const engine::ModelPtr small = compiled(pile(4, "")), large = compiled(sparse_pile(""));
  engine::Physics one(small, {}), other(large, {}), alone(small, {}), other_alone(large, {});
  std::vector<double> in_turn, other_in_turn;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (int step = 0; step < 60; ++step) {
    append(in_turn, trajectory(one, 1));
    append(other_in_turn, trajectory(other, 1));
  }
  EXPECT_EQ(in_turn, trajectory(alone, 60));
  EXPECT_EQ(other_in_turn, trajectory(other_alone, 60));
}

// 2.2 million numbers are more than 16 MB.
TEST(Scratch, IsTheirOwnOfLargeWorlds) {
  engine::Physics large(compiled(sparse_pile("<size nstack='2200000'/>")), {});
  const mjtNum* const own = large.data().stack;
  const engine::Scratch scratch(large.model(), large.data());
  EXPECT_EQ(large.data().stack, own);
}

TEST(Scratch, IsAnotherWhereOneIsInUse) {
  const engine::ModelPtr model = compiled(sparse_pile(""));
  engine::Physics one(model, {}), other(model, {});
  const mjtNum* first = nullptr;
  {
    const engine::Scratch outer(one.model(), one.data());
    const engine::Scratch inner(other.model(), other.data());
    first = one.data().stack;
    EXPECT_NE(one.data().stack, other.data().stack);
    EXPECT_NE(one.data().efc_J, other.data().efc_J);
  }
  EXPECT_NE(one.data().stack, first);
}

#endif

}  // namespace
}  // namespace mimo::test
