#include "programs/random_actions.h"

#include <cmath>

namespace cli {

RandomActions::RandomActions(const mimo::Env& env, std::uint64_t seed) : generator_(seed) {
  for (const mimo_action& action : env.layout().actions()) {  // an actuator without ctrlrange has no bounds
    bounds_.push_back({std::isfinite(action.low) ? action.low : -1, std::isfinite(action.high) ? action.high : 1});
  }
}

std::vector<float> RandomActions::draw() {
  std::vector<float> action;
  for (const Bounds& bounds : bounds_) {
    // Not std::uniform_real_distribution, whose numbers differ between standard libraries.
    const double share = static_cast<double>(generator_() >> 11) * 0x1.0p-53;
    action.push_back(static_cast<float>(bounds.low + share * (bounds.high - bounds.low)));
  }
  return action;
}

}  // namespace cli
