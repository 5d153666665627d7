#include "motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "angles.h"
#include "csv.h"
#include "facts.h"
#include "failure.h"

namespace cli {
namespace {

constexpr char kTime[] = "time";
constexpr char kPrefix[] = "robot:";  // of an infant's joints
const std::vector<std::string> kFreeParts = {"x", "y", "z", "qw", "qx", "qy", "qz"};

// Where a column's numbers go, and of which hinge they are the angle; -1 for none.
struct Target {
  std::size_t place;
  std::int32_t hinge;
};

struct Joint {
  std::int32_t id;
  std::size_t place, width;
};

std::vector<Joint> joints_of(const mimo::Env& env) {
  std::vector<Joint> joints;
  std::size_t place = 0;
  for (const std::int32_t id : env.ids(MIMO_JOINT)) {
    const std::size_t width = env.width(MIMO_JOINT_POSITION, {id});
    joints.push_back({id, place, width});
    place += width;
  }
  return joints;
}

// All columns that there may be.
std::map<std::string, Target> targets_of(const mimo::Env& env) {
  std::map<std::string, Target> targets;
  const std::vector<std::int32_t> roots = infants(env);
  const std::int32_t root = roots.empty() ? -1 : roots[0];
  for (const Joint& joint : joints_of(env)) {
    std::string name = joint_label(env, joint.id);
    if (name.compare(0, sizeof kPrefix - 1, kPrefix) == 0) name.erase(0, sizeof kPrefix - 1);
    if (joint.width == 1) targets[name] = {joint.place, joint.id};
    if (joint.width != 7) continue;
    const bool first = env.body_of(MIMO_JOINT, joint.id) == root;
    for (std::size_t i = 0; i < 7; ++i) {
      const Target target = {joint.place + i, -1};
      targets[name + ":" + kFreeParts[i]] = target;
      if (first) targets["root:" + kFreeParts[i]] = target;
    }
  }
  return targets;
}

Target target_of(const std::string& path, const std::map<std::string, Target>& targets, const std::string& column) {
  const bool prefixed = column.compare(0, sizeof kPrefix - 1, kPrefix) == 0;
  const auto found = targets.find(prefixed ? column.substr(sizeof kPrefix - 1) : column);
  if (found != targets.end()) return found->second;
  std::string some;
  for (const auto& [name, target] : targets) {
    if (some.size() > 200) break;
    some += (some.empty() ? "" : ", ") + name;
  }
  throw Failure(path + ": the body has no joint for column '" + column + "'; there are: " + some + ", ...");
}

std::vector<double> column_of(const NumberTable& table, std::size_t number, double scale) {
  std::vector<double> values;
  for (const auto& row : table.rows) values.push_back(scale * row[number]);
  return values;
}

void require_increasing(const std::string& path, const std::vector<double>& times) {
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) continue;
    throw Failure(path + ": time does not increase in row " + std::to_string(i + 1) + ", " + std::to_string(times[i]) +
                  " after " + std::to_string(times[i - 1]));
  }
}

// What a table tells of the positions, by their places.
struct Column {
  std::int32_t hinge;  // the joint whose angle that is, -1 where it is none
  std::vector<double> values;
};
using Columns = std::map<std::size_t, Column>;

Columns columns_of(const std::string& path, const NumberTable& table, bool degrees, const mimo::Env& env) {
  const auto targets = targets_of(env);
  Columns columns;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (table.names[i] == kTime) continue;
    const Target target = target_of(path, targets, table.names[i]);
    const bool turns = target.hinge >= 0;
    columns[target.place] = {target.hinge, column_of(table, i, turns && degrees ? kDegree : 1)};
  }
  return columns;
}

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

// The turn that leads from one to the other, seen from the first, as an axis times its angle.
std::array<double, 3> turn_between(const double* from, const double* to) {
  using Quaternion = std::array<double, 4>;
  const Quaternion c = {from[0], -from[1], -from[2], -from[3]};
  const Quaternion d = {c[0] * to[0] - c[1] * to[1] - c[2] * to[2] - c[3] * to[3],
                        c[0] * to[1] + c[1] * to[0] + c[2] * to[3] - c[3] * to[2],
                        c[0] * to[2] - c[1] * to[3] + c[2] * to[0] + c[3] * to[1],
                        c[0] * to[3] + c[1] * to[2] - c[2] * to[1] + c[3] * to[0]};
  const double sine = std::sqrt(d[1] * d[1] + d[2] * d[2] + d[3] * d[3]);
  const double angle = 2 * std::atan2(sine, d[0]);
  const double scale = sine < 1e-12 ? 2 : (angle > kPi ? angle - 2 * kPi : angle) / sine;
  return {scale * d[1], scale * d[2], scale * d[3]};
}

}  // namespace

Motion::Motion(const std::string& path, bool degrees, const mimo::Env& env)
    : still_(env.get_values(MIMO_JOINT_POSITION, env.ids(MIMO_JOINT))) {
  const NumberTable table = read_numbers(path, "joint");
  const auto found = std::find(table.names.begin(), table.names.end(), kTime);
  if (found == table.names.end()) throw Failure(path + " has no column 'time'");
  const std::vector<double> times = column_of(table, static_cast<std::size_t>(found - table.names.begin()), 1);
  require_increasing(path, times);
  first_ = times.front();
  last_ = times.back();
  rows_ = times.size();
  Columns columns = columns_of(path, table, degrees, env);
  for (const Joint& joint : joints_of(env)) {
    if (joint.width != 7) continue;
    quaternions_.push_back(joint.place + 3);
    unwind(path, columns, joint.place + 3);
  }
  for (const auto& [place, column] : columns) {
    const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
    tracks_.push_back({place, Spline(times, column.values), *low, *high, column.hinge});
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
    const std::size_t linear = joint.width == 7 ? 3 : joint.width == 1 ? 1 : 0;
    for (std::size_t i = 0; i < linear; ++i) {
      velocities.push_back((now[joint.place + i] - before[joint.place + i]) / step);
    }
    if (joint.width < 4) continue;
    const std::size_t first = joint.place + (joint.width == 7 ? 3 : 0);
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
