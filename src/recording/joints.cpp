#include "recording/joints.h"

namespace mimo::recording {
namespace {

int joints_of(const env::World& world) { return env::count(world, env::Kind::kJoint); }

}  // namespace

std::string joint_names(const env::World& world) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) names += std::string(env::name(world, env::Kind::kJoint, i)) + "\n";
  return names;
}

std::string joint_columns(const env::World& world, env::Quantity quantity) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) {
    for (int left = env::width(world.model(), &world, quantity, i); left > 0; --left) {
      names += std::string(env::name(world, env::Kind::kJoint, i)) + "\n";
    }
  }
  return names;
}

void read_joints(const env::World& world, env::Quantity quantity, std::vector<double>& values) {
  const env::Ids all(joints_of(world));
  values.resize(env::width(world, quantity, all));
  env::get(world, quantity, all, false, Span<double>(values));
}

}  // namespace mimo::recording
