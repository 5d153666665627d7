#include "motion/retarget.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/bvh.h"
#include "programs/csv.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/summary.h"

namespace cli {
namespace {

// Parts that point somewhere: to the next one. Trunk, head and feet are alike in all who stand.
const std::map<std::string, std::string> kLimbs = {
    {"upper_arm", "lower_arm"}, {"lower_arm", "hand"}, {"upper_leg", "lower_leg"}, {"lower_leg", "foot"}};

// Rows of a file: a joint's name and the body that it moves.
std::map<std::string, std::string> read_map(const std::string& path) {
  std::map<std::string, std::string> names;
  for (const TextRow& row : read_texts(path)) {
    const auto fail = [&, line = row.line](const std::string& what) {
      throw Failure(path + ", line " + std::to_string(line) + ": " + what);
    };
    if (row.cells.size() != 2) {
      fail("expected 'joint,body', found " + std::to_string(row.cells.size()) + " cells, the first '" + row.cells[0] +
           "'");
    }
    if (!names.emplace(row.cells[0], row.cells[1]).second) fail("joint '" + row.cells[0] + "' is there twice");
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

  std::vector<Eigen::Isometry3d> rest_of(const Bvh& bvh, int frame) const;
  void choose_bodies(const RetargetOptions& options);
  std::map<std::string, std::size_t> mapped_bodies(const std::string& map) const;
  Eigen::Vector3d upwards(const std::string& given) const;
  std::vector<Eigen::Vector3d> upright_parts() const;
  void stand_upright();
  void find_axes(const Eigen::Vector3d& above);
  void find_rest();
  void find_scale(double given);
  const Pair* pair_of(const std::string& body) const;
  void name_joints(const std::map<std::string, std::size_t>& moving);
  std::int32_t find_body(const std::string& name) const;
  Eigen::Vector3d place(std::int32_t body) const;
  Eigen::Quaterniond orientation(std::int32_t body) const;
  std::optional<Eigen::Vector3d> between(const std::string& from, const std::string& to) const;
  std::optional<Eigen::Vector3d> direction(const std::string& from, const std::string& to) const;

  std::string path_;
  mimo::Env& env_;
  Bvh bvh_;
  std::vector<Eigen::Isometry3d> rest_;
  std::string prefix_;  // of the infant's bodies
  std::vector<Pair> pairs_;
  std::map<std::string, std::size_t> joints_;        // by bodies, also by bodies that do not move
  Eigen::Quaterniond axes_;                          // from the file's to the world's
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();  // of the hip
  double scale_ = 1;
  std::vector<std::string> notes_;
};

Retarget::Retarget(const std::string& path, const RetargetOptions& options, mimo::Env& env)
    : path_(path), env_(env), bvh_(read_bvh(path)), rest_(rest_of(bvh_, options.rest_frame)) {
  const std::vector<mimo_agent_info> agents = env.agents();
  if (infants(env).empty()) throw Failure(path + ": the scene has no infant that could move like it");
  prefix_ = agents.empty() ? "" : prefix(agents[0]);
  choose_bodies(options);
  if (const Pair* const hip = pair_of("hip")) start_ = place(hip->body);
  stand_upright();
  find_axes(upwards(options.up));
  find_rest();
  find_scale(options.scale);
}

std::int32_t Retarget::find_body(const std::string& name) const {
  for (const std::int32_t body : env_.ids(MIMO_BODY)) {
    if (env_.name(MIMO_BODY, body) == prefix_ + name) return body;
  }
  return -1;
}

std::vector<Eigen::Isometry3d> Retarget::rest_of(const Bvh& bvh, int frame) const {
  if (frame < 0) return bvh.rest();
  const auto number = static_cast<std::size_t>(frame);
  if (number < bvh.frames.size()) return bvh.poses(number);
  throw Failure(path_ + ": --rest-frame is " + std::to_string(frame) + ", the frames are 0 to " +
                std::to_string(bvh.frames.size() - 1));
}

// Joints by bodies, as the user's file has them.
std::map<std::string, std::size_t> Retarget::mapped_bodies(const std::string& map) const {
  std::map<std::string, std::size_t> bodies;
  for (const auto& [joint, body] : read_map(map)) {
    const auto is_it = [&name = joint](const BvhJoint& one) { return one.name == name; };
    const auto found = std::find_if(bvh_.joints.begin(), bvh_.joints.end(), is_it);
    if (found == bvh_.joints.end()) throw Failure(map + ": " + path_ + " has no joint '" + joint + "'");
    if (std::find_if(found + 1, bvh_.joints.end(), is_it) != bvh_.joints.end()) {
      throw Failure(map + ": " + path_ + " has two joints '" + joint + "', expected one");
    }
    if (find_body(body) < 0) {
      throw Failure(map + ": the infant has no body '" + body + "'; there are: " + body_names(env_));
    }
    const auto number = static_cast<std::size_t>(found - bvh_.joints.begin());
    if (!bodies.emplace(body, number).second) throw Failure(map + ": two joints move '" + body + "', expected one");
  }
  if (bodies.empty()) throw Failure(map + ": expected lines of joint,body, and there are none");
  return bodies;
}

void Retarget::choose_bodies(const RetargetOptions& options) {
  const bool own = !options.map.empty();
  const std::map<std::string, std::size_t> bodies = own ? mapped_bodies(options.map) : usual_bodies(bvh_.joints);
  if (!own) check_whole(bodies, bvh_.joints, path_);
  name_joints(bodies);
  std::map<std::size_t, std::string> by_joint;
  for (const auto& [body, joint] : bodies) by_joint[joint] = body;
  std::string without;
  for (std::size_t i = 0; i < bvh_.joints.size(); ++i) {
    const auto found = by_joint.find(i);
    const std::int32_t body = found == by_joint.end() ? -1 : find_body(found->second);
    if (body < 0) {  // the mitten has no toes
      without += (without.empty() ? "" : ", ") + bvh_.joints[i].name;
    } else {
      pairs_.push_back({i, body, found->second, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()});
    }
  }
  notes_ = bvh_.notes;
  if (!without.empty()) notes_.push_back("joints that move no body: " + without);
}

// A map may name an arm alone. Joints of usual names still tell how the skeleton stands and how large it is.
void Retarget::name_joints(const std::map<std::string, std::size_t>& moving) {
  joints_ = moving;
  for (const auto& [body, joint] : usual_bodies(bvh_.joints)) {
    const auto is_it = [number = joint](const auto& one) { return one.second == number; };
    if (std::none_of(moving.begin(), moving.end(), is_it)) joints_.emplace(body, joint);
  }
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
  const auto a = joints_.find(from), b = joints_.find(to);
  if (a == joints_.end() || b == joints_.end()) return {};
  return rest_[b->second].translation() - rest_[a->second].translation();
}

// What points upwards in who stands: the trunk, and the legs from the feet.
std::vector<Eigen::Vector3d> Retarget::upright_parts() const {
  std::vector<Eigen::Vector3d> parts;
  const auto add = [&](const std::string& from, const std::string& to) {
    if (const auto part = between(from, to); part && part->norm() > 1e-9) parts.push_back(part->normalized());
  };
  add("hip", "head");
  for (const std::string side : {"left_", "right_"}) {
    add(side + "lower_leg", side + "upper_leg");
    add(side + "foot", side + "lower_leg");
  }
  return parts;
}

// The file's axis that points upwards, as it is given or as the skeleton stands. A skeleton whose rest pose is no
// standing one would be bent by what its bones are turned there; one that leans, or of which no part tells, may mean
// either.
Eigen::Vector3d Retarget::upwards(const std::string& given) const {
  constexpr double kLeast = 0.5;  // 60 degrees from what is up
  const std::vector<Eigen::Vector3d> parts = upright_parts();
  const auto stands = [&](const Eigen::Vector3d& axis) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const Eigen::Vector3d& part) { return part.dot(axis) > kLeast; });
  };
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  const bool by_y = stands(y), by_z = stands(z);
  if (by_y && by_z && given.empty()) {
    throw Failure(path_ + ": no joint tells whether the file's y or its z points up; --up does");
  }
  if (given != "z" && by_y) return y;
  if (given != "y" && by_z) return z;
  if (by_y || by_z) {
    throw Failure(path_ + ": --up is " + given + ", but the skeleton stands along " + (by_y ? "y" : "z") +
                  ": there its head is above its hips and its feet below");
  }
  throw Failure(
      path_ + ": the skeleton does not stand upright at rest, with its head above its hips and its feet below" +
      ", along y or z; --rest-frame N takes the pose of frame N (from 0) in which it does, whatever its arms do");
}

// Who stands looks at right angles to his left side and to what is up; without hips and arms along the file's z, or x.
void Retarget::find_axes(const Eigen::Vector3d& above) {
  const bool up_is_z = above.z() > 0;
  Eigen::Vector3d left = up_is_z ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  for (const char* limb : {"upper_arm", "upper_leg"}) {
    const auto across = between(std::string("right_") + limb, std::string("left_") + limb);
    if (across && across->cross(above).norm() > 1e-6 * (1 + across->norm())) left = *across;
  }
  left = (left - left.dot(above) * above).normalized();
  Eigen::Matrix3d rows;
  rows << left.cross(above).transpose(), left.transpose(), above.transpose();
  axes_ = Eigen::Quaterniond(rows);
}

// The same where the second has no joint: to what hangs on the first, or to its end site.
std::optional<Eigen::Vector3d> Retarget::direction(const std::string& from, const std::string& to) const {
  std::optional<Eigen::Vector3d> found = between(from, to);
  const Pair* const a = pair_of(from);
  if (!found && a != nullptr) {
    const auto child = std::find_if(bvh_.joints.begin(), bvh_.joints.end(),
                                    [&](const BvhJoint& joint) { return joint.parent == static_cast<int>(a->joint); });
    if (child != bvh_.joints.end()) {
      const auto number = static_cast<std::size_t>(child - bvh_.joints.begin());
      found = rest_[number].translation() - rest_[a->joint].translation();
    } else {
      found = rest_[a->joint].linear() * bvh_.joints[a->joint].end;
    }
  }
  if (found && found->norm() < 1e-9) found.reset();
  return found;
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
    const auto theirs = direction(from, to);
    if (!theirs) {
      throw Failure(path_ + ": nothing tells where '" + bvh_.joints[pair.joint].name + "', which moves " + pair.name +
                    ", points to: it needs a joint or an end site below it");
    }
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
  movement.notes = notes_;
  for (const Pair& pair : pairs_) {
    movement.bodies.emplace_back();
    movement.bodies.back().body = pair.body;
    movement.bodies.back().pointer = pair.pointer;
  }
  const Pair* const hip = pair_of("hip");
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  for (std::size_t frame = 0; frame < bvh_.frames.size(); ++frame) {
    movement.times.push_back(bvh_.frame_seconds * static_cast<double>(frame));
    const std::vector<Eigen::Isometry3d> poses = bvh_.poses(frame);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Eigen::Isometry3d& pose = poses[pairs_[i].joint];
      const Eigen::Quaterniond turned(pose.linear() * rest_[pairs_[i].joint].linear().transpose());
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
