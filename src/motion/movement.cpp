#include "motion/movement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "programs/csv.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr char kTime[] = "time";
constexpr char kPrefix[] = "robot:";  // of an infant's joints

// Where a column's numbers go: a joint's position (`hinge` is -1 where it is no angle), or a part of a body's pose.
struct Target {
  std::size_t place = 0;
  std::int32_t hinge = -1, body = -1;
  std::size_t part = 0;  // in kPoseParts
};
using Targets = std::map<std::string, Target>;

void add_joints(const mimo::Env& env, Targets& targets) {
  const std::vector<std::int32_t> roots = infants(env);
  const std::int32_t root = roots.empty() ? -1 : roots[0];
  for (const Joint& joint : joints_of(env)) {
    std::string name = joint_label(env, joint.id);
    if (name.compare(0, sizeof kPrefix - 1, kPrefix) == 0) name.erase(0, sizeof kPrefix - 1);
    if (joint.width == 1) targets[name] = {joint.place, joint.id};
    if (joint.width != 7) continue;
    const bool first = env.body_of(MIMO_JOINT, joint.id) == root;
    for (std::size_t i = 0; i < 7; ++i) {
      const Target target = {joint.place + i};
      targets[name + ":" + kPoseParts[i]] = target;
      if (first) targets[std::string("root:") + kPoseParts[i]] = target;
    }
  }
}

// A joint's name goes before the same one of a body: the pose of a body that moves freely is that of its joint.
void add_bodies(const mimo::Env& env, Targets& targets) {
  for (const std::int32_t body : env.ids(MIMO_BODY)) {
    if (body == 0) continue;
    for (std::size_t part = 0; part < kPoseParts.size(); ++part) {
      Target target;
      target.body = body;
      target.part = part;
      targets.emplace(env.name(MIMO_BODY, body) + ":" + kPoseParts[part], target);
    }
  }
}

std::string joint_names(const Targets& targets) {
  std::string some;
  for (const auto& [name, target] : targets) {
    if (some.size() > 200) break;
    if (target.body < 0) some += (some.empty() ? "" : ", ") + name;
  }
  return some + ", ...";
}

Target target_of(const std::string& path, const Targets& targets, const std::string& column, const mimo::Env& env) {
  const bool prefixed = column.compare(0, sizeof kPrefix - 1, kPrefix) == 0;
  const auto found = targets.find(prefixed ? column.substr(sizeof kPrefix - 1) : column);
  if (found != targets.end()) return found->second;
  throw Failure(path + ": the body has no joint for column '" + column + "'; there are: " + joint_names(targets) +
                " and :x, :y, :z, :qw, :qx, :qy, :qz of the bodies " + body_names(env));
}

std::vector<double> column_of(const NumberTable& table, std::size_t number, double scale) {
  std::vector<double> values;
  for (const auto& row : table.rows) values.push_back(scale * row[number]);
  return values;
}

void require_increasing(const std::string& path, const std::vector<double>& times) {
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] >= times[i - 1] + kLeastRowSeconds) continue;
    throw Failure(path + ": time does not increase in row " + std::to_string(i + 1) +
                  text(", %.9g after %.9g; expected a microsecond at least", times[i], times[i - 1]));
  }
}

std::vector<double> times_of(const std::string& path, const NumberTable& table) {
  const auto found = std::find(table.names.begin(), table.names.end(), kTime);
  if (found == table.names.end()) throw Failure(path + " has no column 'time'");
  std::vector<double> times = column_of(table, static_cast<std::size_t>(found - table.names.begin()), 1);
  require_increasing(path, times);
  return times;
}

// The columns that a body has, by kPoseParts.
using Parts = std::array<std::optional<std::vector<double>>, 7>;

bool has(const std::string& path, const std::string& name, const Parts& parts, std::size_t first, std::size_t count,
         const char* what) {
  const auto there = std::count_if(&parts[first], &parts[first] + count, [](const auto& part) { return bool(part); });
  if (there != 0 && static_cast<std::size_t>(there) != count) {
    throw Failure(path + ": " + what + " of " + name + " has " + std::to_string(there) + " of its " +
                  std::to_string(count) + " columns");
  }
  return there != 0;
}

Eigen::Quaterniond unit(const std::string& path, const std::string& name, const Eigen::Quaterniond& q) {
  if (q.norm() < 1e-6) throw Failure(path + ": an orientation of " + name + " is 0 0 0 0, expected a quaternion");
  return q.normalized();
}

BodyTrack track_of(const std::string& path, const mimo::Env& env, std::int32_t body, const Parts& parts) {
  BodyTrack track;
  track.body = body;
  const std::string name = env.name(MIMO_BODY, body);
  if (has(path, name, parts, 0, 3, "the position")) {
    for (std::size_t i = 0; i < parts[0]->size(); ++i) {
      track.positions.emplace_back((*parts[0])[i], (*parts[1])[i], (*parts[2])[i]);
    }
  }
  if (has(path, name, parts, 3, 4, "the orientation")) {
    for (std::size_t i = 0; i < parts[3]->size(); ++i) {
      track.orientations.push_back(unit(path, name, {(*parts[3])[i], (*parts[4])[i], (*parts[5])[i], (*parts[6])[i]}));
    }
  }
  return track;
}

}  // namespace

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
  const double sine = rotation.vec().norm();
  const double angle = 2 * std::atan2(sine, rotation.w());
  return (sine < 1e-12 ? 2 : (angle > kPi ? angle - 2 * kPi : angle) / sine) * rotation.vec();
}

std::string body_names(const mimo::Env& env) {
  std::string names;
  for (const std::int32_t body : env.ids(MIMO_BODY)) {
    if (names.size() > 500) return names + ", ...";
    if (body != 0) names += (names.empty() ? "" : ", ") + env.name(MIMO_BODY, body);
  }
  return names;
}

Movement read_movement(const std::string& path, bool degrees, const mimo::Env& env) {
  const NumberTable table = read_numbers(path, "joint");
  Movement movement;
  movement.source = path;
  movement.times = times_of(path, table);
  Targets targets;
  add_joints(env, targets);
  add_bodies(env, targets);
  std::map<std::int32_t, Parts> bodies;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (table.names[i] == kTime) continue;
    const Target target = target_of(path, targets, table.names[i], env);
    std::vector<double> values = column_of(table, i, target.hinge >= 0 && degrees ? kDegree : 1);
    if (target.body >= 0) {
      bodies[target.body][target.part] = std::move(values);
    } else {
      movement.joints[target.place] = {target.hinge, std::move(values)};
    }
  }
  for (const auto& [body, parts] : bodies) movement.bodies.push_back(track_of(path, env, body, parts));
  return movement;
}

}  // namespace cli
