#include "cli/chosen_actions.h"

#include <chrono>
#include <cstddef>

#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

// Of all infants, one after the other.
std::vector<float> spontaneous_actions(const mimo::Env& env) {
  std::vector<float> actions;
  const auto agents = env.agents();
  for (std::size_t agent = 0; agent < agents.size(); ++agent) {
    std::vector<float> own(agents[agent].action_count);
    env.spontaneous(own, MIMO_MOVEMENT_ALL, agent);
    actions.insert(actions.end(), own.begin(), own.end());
  }
  return actions;
}

// A scene that cannot be loaded is the fault of a file, whose name nobody would guess from the scene's.
void take_scene(const std::string& file, const std::string& scene, WorldOptions& world) {
  world.scene = scene;
  try {
    load_scene(world);
  } catch (const mimo::Exception& error) {
    refuse_policy(file, text("its scene: %s", error.what()));
  }
}

}  // namespace

void add_action_options(CLI::App& command, ActionOptions& options) {
  command
      .add_option(
          "--policy", options.policy,
          "Act as this policy does, until the episode is over. By default its file says\nscene, age, and whether "
          "nerves have the delays of that age")
      ->type_name("FILE");
  command.add_flag("--spontaneous", options.spontaneous, "Move as infants of that age do by themselves, not at random")
      ->excludes("--policy");
}

void follow_policy(const CLI::App& command, const ActionOptions& options, WorldOptions& world) {
  if (options.policy.empty()) return;
  const PolicyFile policy = read_policy(options.policy);
  if (command.count("--scene") == 0 && !policy.scene.empty()) take_scene(options.policy, policy.scene, world);
  const bool as_learned = command.count("--delays") == 0;
  if (as_learned) world.age.delays = policy.delays;
  if (command.count("--age") != 0) return;
  if (policy.age) {
    world.age.age = policy.age;
  } else if (as_learned && policy.delays) {
    world.age.age = mimo::growth().age;  // nerves have delays where there is an age
  }
}

ChosenActions::ChosenActions(const mimo::Env& env, const ActionOptions& options, std::uint64_t seed)
    : env_(env), spontaneous_(options.spontaneous), random_(env, seed) {
  if (!options.policy.empty()) policy_.emplace(options.policy).attach(env);
}

std::vector<float> ChosenActions::next(const mimo::Block& block) {
  if (spontaneous_) return spontaneous_actions(env_);
  if (!policy_) return random_.draw();
  const auto start = Clock::now();
  const std::vector<float>& action = policy_->act(block, env_.time());
  thought_ += seconds_since(start);
  return action;
}

}  // namespace cli
