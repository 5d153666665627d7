#include "random_actions.h"

#include <cmath>
#include <tuple>

namespace cli {

RandomActions::RandomActions(const Env& env, std::uint64_t seed) : generator_(seed) {
  std::tie(low_, high_) = env.action_bounds();
  for (std::size_t i = 0; i < low_.size(); ++i) {
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
