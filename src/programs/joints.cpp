#include "programs/joints.h"

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

}  // namespace cli
