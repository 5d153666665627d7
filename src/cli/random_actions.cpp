#include "random_actions.h"

#include <cmath>

namespace cli {

RandomActions::RandomActions(const mimo::Env& env, std::uint64_t seed)
    : generator_(seed), bounds_(env.action_bounds()) {
  // An actuator without ctrlrange has none.
  for (float& low : bounds_.low) low = std::isfinite(low) ? low : -1;
  for (float& high : bounds_.high) high = std::isfinite(high) ? high : 1;
}

std::vector<float> RandomActions::draw() {
  const auto &low = bounds_.low, &high = bounds_.high;
  std::vector<float> action(low.size());
  for (std::size_t i = 0; i < action.size(); ++i) {
    // Not std::uniform_real_distribution, whose numbers differ between standard libraries.
    const double share = static_cast<double>(generator_() >> 11) * 0x1.0p-53;
    action[i] = static_cast<float>(low[i] + share * (static_cast<double>(high[i]) - low[i]));
  }
  return action;
}

}  // namespace cli
