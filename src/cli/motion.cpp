#include "motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "csv.h"
#include "facts.h"
#include "failure.h"

namespace cli {
namespace {

constexpr char kTime[] = "time";
constexpr char kPrefix[] = "robot:";  // of an infant's joints
constexpr double kDegree = 3.14159265358979323846 / 180;
const std::vector<std::string> kFreeParts = {"x", "y", "z", "qw", "qx", "qy", "qz"};

// Where a column's numbers go, and whether they are an angle.
struct Target {
  std::size_t place;
  std::int32_t joint;
  bool hinge;
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
    if (joint.width == 1) targets[name] = {joint.place, joint.id, true};
    if (joint.width != 7) continue;
    const bool first = env.body_of(MIMO_JOINT, joint.id) == root;
    for (std::size_t i = 0; i < 7; ++i) {
      const Target target = {joint.place + i, joint.id, false};
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

using Quaternion = std::array<double, 4>;

// Half a turn and its opposite are one orientation: neighbours are told on one side.
void unwind(std::array<std::vector<double>, 4>& parts) {
  for (std::size_t row = 1; row < parts[0].size(); ++row) {
    double along = 0;
    for (const auto& part : parts) along += part[row] * part[row - 1];
    if (along >= 0) continue;
    for (auto& part : parts) part[row] = -part[row];
  }
}

void normalize(double* q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int i = 0; i < 4; ++i) q[i] /= length;
}

// The turn that leads from one to the other, seen from the first, as an axis times its angle.
std::array<double, 3> turn_between(const double* from, const double* to) {
  const Quaternion c = {from[0], -from[1], -from[2], -from[3]};
  Quaternion d = {c[0] * to[0] - c[1] * to[1] - c[2] * to[2] - c[3] * to[3],
                  c[0] * to[1] + c[1] * to[0] + c[2] * to[3] - c[3] * to[2],
                  c[0] * to[2] - c[1] * to[3] + c[2] * to[0] + c[3] * to[1],
                  c[0] * to[3] + c[1] * to[2] - c[2] * to[1] + c[3] * to[0]};
  const double sine = std::sqrt(d[1] * d[1] + d[2] * d[2] + d[3] * d[3]);
  const double angle = 2 * std::atan2(sine, d[0]);
  const double scale =
      sine < 1e-12 ? 2 : (angle > 3.14159265358979323846 ? angle - 2 * 3.14159265358979323846 : angle) / sine;
  return {scale * d[1], scale * d[2], scale * d[3]};
}

}  // namespace

Motion::Motion(const std::string& path, bool degrees, const mimo::Env& env) {
  const NumberTable table = read_numbers(path, "joint");
  const auto found = std::find(table.names.begin(), table.names.end(), kTime);
  if (found == table.names.end()) throw Failure(path + " has no column 'time'");
  const auto time_column = static_cast<std::size_t>(found - table.names.begin());
  const std::vector<double> times = column_of(table, time_column, 1);
  require_increasing(path, times);
  first_ = times.front();
  last_ = times.back();
  rows_ = times.size();
  still_ = env.get_values(MIMO_JOINT_POSITION, env.ids(MIMO_JOINT));

  const auto targets = targets_of(env);
  std::map<std::size_t, std::vector<double>> columns;
  std::map<std::size_t, Target> told;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (i == time_column) continue;
    const Target target = target_of(path, targets, table.names[i]);
    columns[target.place] = column_of(table, i, target.hinge && degrees ? kDegree : 1);
    told[target.place] = target;
  }
  for (const Joint& joint : joints_of(env)) {
    if (joint.width != 7) continue;
    quaternions_.push_back(joint.place + 3);
    std::array<std::vector<double>, 4> parts;
    std::size_t given = 0;
    for (std::size_t i = 0; i < 4; ++i) given += columns.count(joint.place + 3 + i);
    if (given == 0) continue;
    if (given != 4)
      throw Failure(path + ": an orientation has four columns, qw, qx, qy and qz, not " + std::to_string(given));
    for (std::size_t i = 0; i < 4; ++i) parts[i] = columns[joint.place + 3 + i];
    unwind(parts);
    for (std::size_t i = 0; i < 4; ++i) columns[joint.place + 3 + i] = parts[i];
  }
  for (const auto& [place, values] : columns) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    tracks_.push_back({place, Spline(times, values), *low, *high, told[place].hinge ? told[place].joint : -1});
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
    if (track.joint < 0) continue;
    const auto range = env.get_values(MIMO_JOINT_RANGE, {track.joint});
    if (track.low < range[0] - kRounding || track.high > range[1] + kRounding) {
      names.push_back(env.name(MIMO_JOINT, track.joint));
    }
  }
  return names;
}

}  // namespace cli
