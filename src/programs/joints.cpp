#include "programs/joints.h"

#include <cmath>

namespace cli {

std::vector<Joint> joints_of(const mimo::Env& env) {
  std::vector<Joint> joints;
  std::size_t place = 0, velocity = 0;
  for (const std::int32_t id : env.ids(MIMO_JOINT)) {
    const std::size_t width = env.width(MIMO_JOINT_POSITION, {id}), freedom = env.width(MIMO_JOINT_VELOCITY, {id});
    joints.push_back({id, place, width, velocity, freedom});
    place += width;
    velocity += freedom;
  }
  return joints;
}

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
