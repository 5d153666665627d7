#include "recording/joints.h"

namespace mimo::recording {
namespace {

int joints_of(const env::World& world) { return world.model().njnt; }

std::string name_of(const env::World& world, int joint) {
  return engine::name(world.model(), engine::Kind::kJoint, joint);
}

// Free joints often have no name, but their bodies have.
std::string column_name(const env::World& world, int joint) {
  const std::string own = name_of(world, joint);
  return own.empty() ? engine::name(world.model(), engine::Kind::kBody, world.model().jnt_bodyid[joint]) : own;
}

}  // namespace

std::string joint_names(const env::World& world) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) names += name_of(world, i) + "\n";
  return names;
}

std::string joint_columns(const env::World& world, mimo_quantity quantity) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) {
    for (int left = access::width(access::quantity_of(quantity), world.model(), &world, i); left > 0; --left) {
      names += column_name(world, i) + "\n";
    }
  }
  return names;
}

void read_joints(const env::World& world, mimo_quantity number, std::vector<double>& values) {
  const access::Quantity& quantity = access::quantity_of(number);
  const access::Ids all(joints_of(world));
  values.resize(access::width(world, quantity, all));
  access::get(world, quantity, all, false, Span<double>(values));
}

}  // namespace mimo::recording
