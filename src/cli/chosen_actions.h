// What the infants of a command do: random movements, their own, or what a policy has learned.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <mimo/mimo.hpp>
#include <optional>
#include <string>
#include <vector>

#include "programs/joints.h"
#include "programs/policy.h"
#include "programs/world.h"

namespace cli {

struct ActionOptions {
  std::string policy;  // a file, or "" for movements that nobody learned
  bool spontaneous = false;
};

void add_action_options(CLI::App& command, ActionOptions& options);

// Takes scene, age and nerves from the policy, where `command` got no options for them.
void follow_policy(const CLI::App& command, const ActionOptions& options, WorldOptions& world);

class ChosenActions {
 public:
  // Throws a Failure for a policy that does not fit the world, which outlives this.
  ChosenActions(const mimo::Env& env, const ActionOptions& options, std::uint64_t seed);

  // For the next step, given the last observation.
  std::vector<float> next(const mimo::Block& block);
  // Whether they end with their episode. Random movements go on: there is nothing that they were to reach.
  bool learned() const { return policy_.has_value(); }
  double seconds_thought() const { return thought_; }  // in the policy

 private:
  const mimo::Env& env_;
  bool spontaneous_;
  RandomActions random_;
  std::optional<Policy> policy_;
  double thought_ = 0;
};

}  // namespace cli
