#include "retarget.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "bvh.h"
#include "csv.h"
#include "facts.h"
#include "failure.h"
#include "files.h"
#include "joints.h"

namespace cli {
namespace {

using Names = std::vector<std::pair<const char*, const char*>>;

// What joints are usually called, without case, signs and what is before a colon.
const Names kTrunk = {
    {"hips", "hip"},           {"hip", "hip"},
    {"pelvis", "hip"},         {"spine", "lower_body"},
    {"abdomen", "lower_body"}, {"lowerback", "lower_body"},
    {"spine1", "upper_body"},  {"chest", "upper_body"},
    {"thorax", "upper_body"},  {"head", "head"},
};
// After "left" or "right", and after "l" or "r".
const Names kSides = {
    {"arm", "upper_arm"},    {"uparm", "upper_arm"}, {"forearm", "lower_arm"}, {"elbow", "lower_arm"},
    {"lowarm", "lower_arm"}, {"hand", "hand"},       {"wrist", "hand"},        {"upleg", "upper_leg"},
    {"hip", "upper_leg"},    {"leg", "lower_leg"},   {"lowleg", "lower_leg"},  {"knee", "lower_leg"},
    {"foot", "foot"},        {"ankle", "foot"},      {"toebase", "toes"},      {"toe", "toes"},
};
const Names kShortSides = {
    {"shldr", "upper_arm"}, {"forearm", "lower_arm"}, {"hand", "hand"}, {"thigh", "upper_leg"},
    {"shin", "lower_leg"},  {"foot", "foot"},         {"toe", "toes"},
};

// Bodies by joints.
std::map<std::string, std::string> usual_names() {
  std::map<std::string, std::string> names(kTrunk.begin(), kTrunk.end());
  for (const std::string side : {"left", "right"}) {
    for (const auto& [joint, body] : kSides) names[side + joint] = side + "_" + body;
    for (const auto& [joint, body] : kShortSides) names[side[0] + std::string(joint)] = side + "_" + body;
  }
  return names;
}

// Parts that point somewhere: to the next one. Trunk, head and feet are alike in all who stand.
const std::map<std::string, std::string> kLimbs = {
    {"upper_arm", "lower_arm"}, {"lower_arm", "hand"}, {"upper_leg", "lower_leg"}, {"lower_leg", "foot"}};

std::string plain(const std::string& name) {
  std::string result;
  for (const char c : name.substr(name.rfind(':') + 1)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

// Lines of a file: a joint's name and the body that it moves.
std::map<std::string, std::string> read_map(const std::string& path) {
  std::ifstream file = open_to_read(path);
  std::map<std::string, std::string> names;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (trim(line).empty()) continue;
    const auto comma = line.find(',');
    if (comma == std::string::npos) {
      throw Failure(path + ", line " + std::to_string(number) + ": expected 'joint,body', not '" +
                    std::string(trim(line)) + "'");
    }
    const std::string_view whole = line;
    names[std::string(trim(whole.substr(0, comma)))] = trim(whole.substr(comma + 1));
  }
  return names;
}

class Retarget {
 public:
  Retarget(const std::string& path, const RetargetOptions& options, mimo::Env& env);
  Movement movement() const;

 private:
  struct Pair {
    std::size_t joint;
    std::int32_t body;
    std::string name;         // of the body, without the infant's
    Eigen::Quaterniond rest;  // of the body where the skeleton is at rest, world frame
    Eigen::Vector3d pointer;  // as of a BodyTrack
  };

  void choose_bodies(const RetargetOptions& options);
  void stand_upright();
  void find_axes(const std::string& up);
  void find_rest();
  void find_scale(double given);
  const Pair* pair_of(const std::string& body) const;
  std::int32_t find_body(const std::string& name) const;
  Eigen::Vector3d place(std::int32_t body) const;
  Eigen::Quaterniond orientation(std::int32_t body) const;
  std::optional<Eigen::Vector3d> between(const std::string& from, const std::string& to) const;

  std::string path_;
  mimo::Env& env_;
  Bvh bvh_;
  std::vector<Eigen::Isometry3d> rest_;
  std::string prefix_;  // of the infant's bodies
  std::vector<Pair> pairs_;
  Eigen::Quaterniond axes_;                          // from the file's to the world's
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();  // of the hip
  double scale_ = 1;
};

Retarget::Retarget(const std::string& path, const RetargetOptions& options, mimo::Env& env)
    : path_(path), env_(env), bvh_(read_bvh(path)), rest_(bvh_.rest()) {
  const std::vector<mimo_agent_info> agents = env.agents();
  if (infants(env).empty()) throw Failure(path + ": the scene has no infant that could move like it");
  prefix_ = agents.empty() ? "" : prefix(agents[0]);
  choose_bodies(options);
  if (const Pair* const hip = pair_of("hip")) start_ = place(hip->body);
  stand_upright();
  find_axes(options.up);
  find_rest();
  find_scale(options.scale);
}

std::int32_t Retarget::find_body(const std::string& name) const {
  for (const std::int32_t body : env_.ids(MIMO_BODY)) {
    if (env_.name(MIMO_BODY, body) == prefix_ + name) return body;
  }
  return -1;
}

void Retarget::choose_bodies(const RetargetOptions& options) {
  const bool own = !options.map.empty();
  std::map<std::string, std::string> names = own ? read_map(options.map) : usual_names();
  for (std::size_t i = 0; i < bvh_.joints.size(); ++i) {
    const auto found = names.find(own ? bvh_.joints[i].name : plain(bvh_.joints[i].name));
    if (found == names.end()) continue;
    const std::int32_t body = find_body(found->second);
    if (body < 0) {
      if (!own) continue;
      throw Failure(options.map + ": the infant has no body '" + found->second + "'; there are: " + body_names(env_));
    }
    const auto twice = [&](const Pair& pair) { return pair.body == body; };
    if (std::none_of(pairs_.begin(), pairs_.end(), twice))
      pairs_.push_back({i, body, found->second, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()});
    if (own) names.erase(found);
  }
  if (own && !names.empty()) {
    throw Failure(options.map + ": " + path_ + " has no joint '" + names.begin()->first + "'");
  }
  if (!pairs_.empty()) return;
  std::string some;
  for (const BvhJoint& joint : bvh_.joints) {
    if (some.size() < 200) some += (some.empty() ? "" : ", ") + joint.name;
  }
  throw Failure(path_ + ": none of its joints has a usual name; --map tells which bodies they move. They are: " + some);
}

// All hinges at 0: upright, limbs straight.
void Retarget::stand_upright() {
  std::vector<double> positions;
  for (const Joint& joint : joints_of(env_)) {
    std::vector<double> part(joint.width, 0);
    if (joint.turns()) part[joint.width - 4] = 1;
    positions.insert(positions.end(), part.begin(), part.end());
  }
  env_.set_values(MIMO_JOINT_POSITION, env_.ids(MIMO_JOINT), positions);
}

const Retarget::Pair* Retarget::pair_of(const std::string& body) const {
  const auto is_it = [&](const Pair& pair) { return pair.name == body; };
  const auto found = std::find_if(pairs_.begin(), pairs_.end(), is_it);
  return found == pairs_.end() ? nullptr : &*found;
}

Eigen::Vector3d Retarget::place(std::int32_t body) const {
  const std::vector<double> p = env_.get_values(MIMO_BODY_POSITION | MIMO_NOW, {body});
  return {p[0], p[1], p[2]};
}

Eigen::Quaterniond Retarget::orientation(std::int32_t body) const {
  const std::vector<double> q = env_.get_values(MIMO_BODY_ORIENTATION | MIMO_NOW, {body});
  return {q[0], q[1], q[2], q[3]};
}

// In the file, at rest; none where one of the two is not there.
std::optional<Eigen::Vector3d> Retarget::between(const std::string& from, const std::string& to) const {
  const Pair *a = pair_of(from), *b = pair_of(to);
  if (a == nullptr || b == nullptr) return {};
  return rest_[b->joint].translation() - rest_[a->joint].translation();
}

// Who stands looks at right angles to his left side and to what is up; without hips and arms along the file's z, or x.
void Retarget::find_axes(const std::string& up) {
  const Eigen::Vector3d above = up == "z" ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  Eigen::Vector3d left = up == "z" ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  for (const char* limb : {"upper_arm", "upper_leg"}) {
    const auto across = between(std::string("right_") + limb, std::string("left_") + limb);
    if (across && across->cross(above).norm() > 1e-6 * (1 + across->norm())) left = *across;
  }
  left = (left - left.dot(above) * above).normalized();
  Eigen::Matrix3d rows;
  rows << left.cross(above).transpose(), left.transpose(), above.transpose();
  axes_ = Eigen::Quaterniond(rows);
}

// How limbs are turned about themselves is not looked at: skeletons turn them at other joints than the infant does.
void Retarget::find_rest() {
  for (Pair& pair : pairs_) {
    pair.rest = orientation(pair.body);
    const auto side = pair.name.find('_') + 1;           // behind "left_"
    const bool hand = pair.name.substr(side) == "hand";  // lies at rest as its arm does
    const auto limb = kLimbs.find(hand ? "lower_arm" : pair.name.substr(side));
    if (limb == kLimbs.end()) continue;
    const std::string from = pair.name.substr(0, side) + limb->first, to = pair.name.substr(0, side) + limb->second;
    const auto theirs = between(from, to);
    if (!theirs || theirs->norm() < 1e-9) continue;
    const Eigen::Vector3d ours = place(find_body(to)) - place(find_body(from));
    if (!hand) pair.pointer = pair.rest.conjugate() * ours.normalized();
    pair.rest = Eigen::Quaterniond::FromTwoVectors(ours, axes_ * *theirs) * pair.rest;
  }
}

void Retarget::find_scale(double given) {
  scale_ = given;
  if (given > 0 || pair_of("hip") == nullptr) return;
  for (const std::string side : {"left_", "right_"}) {
    const auto thigh = between(side + "upper_leg", side + "lower_leg"),
               shin = between(side + "lower_leg", side + "foot");
    if (!thigh || !shin || thigh->norm() + shin->norm() < 1e-9) continue;
    const auto ours = [&](const char* from, const char* to) {
      return (place(find_body(side + to)) - place(find_body(side + from))).norm();
    };
    scale_ = (ours("upper_leg", "lower_leg") + ours("lower_leg", "foot")) / (thigh->norm() + shin->norm());
    return;
  }
  throw Failure(path_ + " has no legs whose length would tell its unit; --scale says how many metres that is");
}

Movement Retarget::movement() const {
  Movement movement;
  movement.source = path_;
  movement.of_another = true;
  for (const Pair& pair : pairs_) movement.bodies.push_back({pair.body, {}, {}, pair.pointer});
  const Pair* const hip = pair_of("hip");
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  for (std::size_t frame = 0; frame < bvh_.frames.size(); ++frame) {
    movement.times.push_back(bvh_.frame_seconds * static_cast<double>(frame));
    const std::vector<Eigen::Isometry3d> poses = bvh_.poses(frame);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Eigen::Isometry3d& pose = poses[pairs_[i].joint];
      const Eigen::Quaterniond turned(pose.linear());
      movement.bodies[i].orientations.push_back(axes_ * turned * axes_.conjugate() * pairs_[i].rest);
      if (&pairs_[i] != hip) continue;
      Eigen::Vector3d at = scale_ * (axes_ * pose.translation());
      if (frame == 0) first = {at.x() - start_.x(), at.y() - start_.y(), 0};  // begins where the scene has the infant
      movement.bodies[i].positions.emplace_back(at - first);
    }
  }
  return movement;
}

}  // namespace

Movement read_skeleton(const std::string& path, const RetargetOptions& options, mimo::Env& env) {
  const std::vector<double> before = env.get_values(MIMO_JOINT_POSITION, env.ids(MIMO_JOINT));
  Movement movement = Retarget(path, options, env).movement();
  env.set_values(MIMO_JOINT_POSITION, env.ids(MIMO_JOINT), before);
  return movement;
}

}  // namespace cli
