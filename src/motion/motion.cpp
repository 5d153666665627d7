#include "motion/motion.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "programs/failure.h"
#include "programs/joints.h"

namespace cli {
namespace {

using Columns = std::map<std::size_t, JointTrack>;

// A quaternion and its opposite are one orientation: neighbours of the one that starts at `place` are told on one side.
void unwind(const std::string& path, Columns& columns, std::size_t place) {
  std::vector<std::vector<double>*> parts;
  for (std::size_t i = place; i < place + 4; ++i) {
    if (const auto found = columns.find(i); found != columns.end()) parts.push_back(&found->second.values);
  }
  if (parts.empty()) return;
  if (parts.size() != 4) {
    throw Failure(path + ": an orientation has four columns, qw, qx, qy and qz, not " + std::to_string(parts.size()));
  }
  for (std::size_t row = 1; row < parts[0]->size(); ++row) {
    double along = 0;
    for (const auto* part : parts) along += (*part)[row] * (*part)[row - 1];
    if (along >= 0) continue;
    for (auto* part : parts) (*part)[row] = -(*part)[row];
  }
}

void normalize(double* q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int i = 0; i < 4; ++i) q[i] /= length;
}

// The turn that leads from one to the other, seen from the first.
Eigen::Vector3d turn_between(const double* from, const double* to) {
  const Eigen::Quaterniond first(from[0], from[1], from[2], from[3]), second(to[0], to[1], to[2], to[3]);
  return rotation_vector(first.conjugate() * second);
}

}  // namespace

Motion::Motion(const Movement& movement, const mimo::Env& env)
    : still_(env.get_values(MIMO_JOINT_POSITION, env.ids(MIMO_JOINT))),
      first_(movement.times.front()),
      last_(movement.times.back()),
      rows_(movement.times.size()) {
  Columns columns = movement.joints;
  for (const Joint& joint : joints_of(env)) {
    if (joint.width != 7) continue;
    quaternions_.push_back(joint.quaternion());
    unwind(movement.source, columns, joint.quaternion());
  }
  for (const auto& [place, column] : columns) {
    const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
    tracks_.push_back({place, Spline(movement.times, column.values), *low, *high, column.hinge});
  }
}

std::vector<double> Motion::positions(double seconds) const {
  std::vector<double> positions = still_;
  for (const Track& track : tracks_) positions[track.place] = track.curve.at(first_ + seconds);
  for (const std::size_t first : quaternions_) normalize(&positions[first]);
  return positions;
}

std::vector<double> Motion::velocities(const mimo::Env& env, double seconds) const {
  const double step = env.timestep();
  const std::vector<double> now = positions(seconds), before = positions(seconds - step);
  std::vector<double> velocities;
  for (const Joint& joint : joints_of(env)) {
    for (std::size_t i = 0; i < joint.linear(); ++i) {
      velocities.push_back((now[joint.place + i] - before[joint.place + i]) / step);
    }
    if (!joint.turns()) continue;
    const std::size_t first = joint.quaternion();
    for (const double turn : turn_between(&before[first], &now[first])) velocities.push_back(turn / step);
  }
  return velocities;
}

std::vector<std::string> Motion::beyond_limits(const mimo::Env& env) const {
  constexpr double kRounding = 1e-6;
  std::vector<std::string> names;
  for (const Track& track : tracks_) {
    if (track.hinge < 0) continue;
    const auto range = env.get_values(MIMO_JOINT_RANGE, {track.hinge});
    if (track.low < range[0] - kRounding || track.high > range[1] + kRounding) {
      names.push_back(env.name(MIMO_JOINT, track.hinge));
    }
  }
  return names;
}

}  // namespace cli
