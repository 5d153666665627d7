#include "cli/episode.h"

#include "cli/behaviours.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

const char* word(std::int32_t outcome) {
  if (outcome == MIMO_OUTCOME_SUCCESS) return "success";
  return outcome == MIMO_OUTCOME_FAILURE ? "failure" : "none";
}

// What the measure of a behaviour is now; null for another task.
Json measure_of(const std::vector<double>& goal, const std::vector<double>& achieved, const WorldOptions& options) {
  mimo::Scene scene = load_scene(options);
  const auto behaviour = behaviour_of(scene);
  if (!behaviour || goal.empty()) return nullptr;
  return {{"name", behaviour->measure},         {"unit", behaviour->unit},
          {"value", achieved.front()},          {"threshold", goal.front()},
          {"at_most", behaviour->at_most != 0}, {"held_seconds", achieved.back()},
          {"hold_seconds", goal.back()}};
}

}  // namespace

void Episode::add(const mimo::Results& results, double simulated) {
  ++steps_;
  seconds_ = simulated;
  reward_ += results.reward.at(0);
  outcome_ = results.outcome.at(0);
  if (outcome_ == MIMO_OUTCOME_SUCCESS && !reached_) reached_ = simulated;
  over_ = results.terminated.at(0) != 0 || results.truncated.at(0) != 0;
}

Json Episode::describe(const mimo::Env& env, const WorldOptions& options) const {
  const std::vector<double> goal = env.get_values(MIMO_AGENT_GOAL, {0});
  const std::vector<double> achieved = env.get_values(MIMO_AGENT_ACHIEVED, {0});
  return {{"scene", options.scene},
          {"task", env.task()},
          {"seed", options.seed},
          {"steps", steps_},
          {"seconds", seconds_},
          {"over", over_},
          {"reward", reward_},
          {"outcome", word(outcome_)},
          {"reached_after_seconds", reached_ ? Json(*reached_) : Json()},
          {"measure", env.task() == kBehaviour ? measure_of(goal, achieved, options) : Json()},
          {"goal", goal},
          {"achieved", achieved}};
}

}  // namespace cli
