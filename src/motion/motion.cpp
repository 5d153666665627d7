#include "motion/motion.h"

#include <algorithm>
#include <cmath>

#include "motion/movement.h"
#include "programs/joints.h"
#include "programs/program.h"

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

// A Butterworth filter of second order, there and back, so that nothing comes later. At both ends the values go on as
// their mirror image about the last one.
class LowPass {
 public:
  LowPass(double cutoff, double rate) {
    const double k = std::tan(kPi * cutoff / rate), whole = 1 + std::sqrt(2.0) * k + k * k;
    b_ = k * k / whole;
    a1_ = 2 * (k * k - 1) / whole;
    a2_ = (1 - std::sqrt(2.0) * k + k * k) / whole;
  }

  std::vector<double> filtered(const std::vector<double>& values) const {
    const std::size_t n = values.size(), more = std::min<std::size_t>(n - 1, kMirrored);
    std::vector<double> all;
    for (std::size_t i = more; i > 0; --i) all.push_back(2 * values.front() - values[i]);
    all.insert(all.end(), values.begin(), values.end());
    for (std::size_t i = 1; i <= more; ++i) all.push_back(2 * values.back() - values[n - 1 - i]);
    for (int way = 0; way < 2; ++way) {
      run(all);
      std::reverse(all.begin(), all.end());
    }
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(more);
    return {first, first + static_cast<std::ptrdiff_t>(n)};
  }

 private:
  static constexpr std::size_t kMirrored = 100;

  // Begins as if the first value had always been there.
  void run(std::vector<double>& values) const {
    double second = (b_ - a2_) * values[0], first = (2 * b_ - a1_) * values[0] + second;
    for (double& value : values) {
      const double given = value;
      value = b_ * given + first;
      first = 2 * b_ * given - a1_ * value + second;
      second = b_ * given - a2_ * value;
    }
  }

  double b_, a1_, a2_;
};

LowPass low_pass(const Movement& movement, double cutoff) {
  constexpr std::size_t kLeastRows = 11;
  const std::vector<double>& times = movement.times;
  const double step = (times.back() - times.front()) / static_cast<double>(std::max<std::size_t>(2, times.size()) - 1);
  bool equal = times.size() >= kLeastRows;
  for (std::size_t i = 1; i < times.size(); ++i)
    equal = equal && std::abs(times[i] - times[i - 1] - step) < 0.01 * step;
  if (!equal) {
    throw Failure(movement.source + text(": --cutoff needs %zu rows or more in equal steps of time; there are %zu",
                                         kLeastRows, times.size()));
  }
  if (!(cutoff < 0.5 / step)) {
    throw Failure(movement.source +
                  text(": --cutoff is %g Hz, expected less than half of the rate, %g Hz", cutoff, 0.5 / step));
  }
  return {cutoff, 1 / step};
}

}  // namespace

Spline::Spline(std::vector<double> times, std::vector<double> values)
    : times_(std::move(times)), values_(std::move(values)), bends_(values_.size(), 0) {
  // Of each inner point: equal slopes from both sides, solved from the first to the last and back.
  const std::size_t n = values_.size();
  std::vector<double> share(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = times_[i] - times_[i - 1], right = times_[i + 1] - times_[i];
    const double turn = (values_[i + 1] - values_[i]) / right - (values_[i] - values_[i - 1]) / left;
    const double pivot = 2 * (left + right) - left * share[i - 1];
    share[i] = right / pivot;
    bends_[i] = (6 * turn - left * bends_[i - 1]) / pivot;
  }
  for (std::size_t i = n; i-- > 1;) {
    if (i + 1 < n) bends_[i] -= share[i] * bends_[i + 1];
  }
}

double Spline::at(double time) const {
  const std::size_t n = values_.size();
  if (n == 1) return values_[0];
  const auto found = std::upper_bound(times_.begin(), times_.end(), time);
  const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(found - times_.begin()), 1, n - 1);
  const double width = times_[i] - times_[i - 1];
  const double a = values_[i - 1], b = values_[i], p = bends_[i - 1], q = bends_[i];
  const double slope = (b - a) / width;
  if (time < times_[0]) return a + (time - times_[0]) * (slope - width * (2 * p + q) / 6);
  if (time > times_[n - 1]) return b + (time - times_[n - 1]) * (slope + width * (p + 2 * q) / 6);
  const double u = (time - times_[i - 1]) / width, v = 1 - u;
  return v * a + u * b + width * width / 6 * ((v * v * v - v) * p + (u * u * u - u) * q);
}

Motion::Motion(const Movement& movement, const mimo::Env& env, double cutoff)
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
  if (cutoff > 0) {
    const LowPass filter = low_pass(movement, cutoff);
    for (auto& [place, column] : columns) column.values = filter.filtered(column.values);
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
