#include "recording/joints.h"

namespace mimo::recording {
namespace {

int joints_of(const env::World& world) { return access::count(world, access::Kind::kJoint); }

// Free joints often have no name, but their bodies have.
std::string column_name(const env::World& world, int joint) {
  const std::string own = access::name(world, access::Kind::kJoint, joint);
  return own.empty() ? access::name(world, access::Kind::kBody, world.model().jnt_bodyid[joint]) : own;
}

}  // namespace

std::string joint_names(const env::World& world) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) names += std::string(access::name(world, access::Kind::kJoint, i)) + "\n";
  return names;
}

std::string joint_columns(const env::World& world, access::Quantity quantity) {
  std::string names;
  for (int i = 0; i < joints_of(world); ++i) {
    for (int left = access::width(world.model(), &world, quantity, i); left > 0; --left) {
      names += column_name(world, i) + "\n";
    }
  }
  return names;
}

void read_joints(const env::World& world, access::Quantity quantity, std::vector<double>& values) {
  const access::Ids all(joints_of(world));
  values.resize(access::width(world, quantity, all));
  access::get(world, quantity, all, false, Span<double>(values));
}

}  // namespace mimo::recording
