#include "random_actions.h"

#include <cmath>

namespace cli {

RandomActions::RandomActions(const Env& env, std::uint64_t seed) : generator_(seed) {
  std::size_t count = 0;
  check(mimo_env_action_size(env.get(), &count));
  low_.resize(count);
  high_.resize(count);
  if (count != 0) check(mimo_env_action_bounds(env.get(), low_.data(), high_.data(), count));
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(low_[i])) low_[i] = -1;  // an actuator without ctrlrange
    if (!std::isfinite(high_[i])) high_[i] = 1;
  }
}

std::vector<float> RandomActions::draw() {
  std::vector<float> action(low_.size());
  for (std::size_t i = 0; i < action.size(); ++i) {
    // Not std::uniform_real_distribution, whose numbers differ between standard libraries.
    const double share = static_cast<double>(generator_() >> 11) * 0x1.0p-53;
    action[i] = static_cast<float>(low_[i] + share * (static_cast<double>(high_[i]) - low_[i]));
  }
  return action;
}

}  // namespace cli
