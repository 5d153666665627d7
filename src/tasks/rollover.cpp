// Rolling over: the infant lies on its back or its belly and is to turn onto the other side with little effort.
#include <algorithm>

#include "base/functions.h"
#include "base/numbers.h"
#include "engine/model.h"
#include "tasks/infant.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"rollover/episode_steps", 1000, 0, 1e9, "Steps after which an episode is cut off; 0: never"},
    {"rollover/ends_on_success", 0, 0, 1, "1: success ends the episode"},
    {"rollover/start", 0, 0, 2, "0: on the back; 1: on the belly; 2: drawn for each episode"},
    {"rollover/over_chest", 0, 0, 1, "0: the hip is to turn over; 1: hip and chest, by their mean"},
    {"rollover/success", 0.8, 0, 1, "Success is a posture of at least this"},
    {"rollover/posture_weight", 1, -1e9, 1e9, "Reward of having turned over"},
    {"rollover/control_weight", 0.01, -1e9, 1e9,
     "The sum of the squared control inputs times this is subtracted from the reward"},
    {"rollover/pose_noise", 0.01, 0, 1, "Every joint starts at most this far from the stored pose, rad"},
    {"rollover/settle_steps", 100, 0, 10000, "Physics steps without control at the start of an episode"},
};

enum Start { kBack, kBelly, kDrawn };

class Rollover : public Task {
 public:
  Rollover(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics& physics, Random& random) override;
  void evaluate(const engine::Physics& physics) override;
  // The posture that is a success, and the posture.
  int goal_size() const override { return 1; }
  void goal(const mjData&, double* out) const override { *out = success_posture_; }
  void achieved(const mjData& data, double* out) const override { *out = posture(data); }
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  enum { kPosture, kControl };

  void turn_over(engine::Physics& physics) const;
  double posture(const mjData& data) const;

  body::Body body_;
  std::vector<int> turning_;  // bodies
  int root_address_;          // in qpos
  Start start_;
  double success_posture_, posture_weight_, control_weight_, pose_noise_;
  int settle_steps_;
  // State of the episode.
  bool from_belly_ = false;
};

Rollover::Rollover(const mjModel& model, const body::Body& body, const Settings& settings)
    : Task({{"posture", 0}, {"control", 0}}), body_(body), root_address_(engine::free_joint_address(model, body.root)) {
  const auto get = [&](const char* name) { return settings[std::string("rollover/") + name]; };
  const auto find = [&](const char* name) {
    return engine::find_or_fail(model, engine::Kind::kBody, body.prefix + name);
  };
  turning_.push_back(find("hip"));
  if (get("over_chest") != 0) turning_.push_back(find("upper_body"));
  episode_steps_ = static_cast<std::uint64_t>(get("episode_steps"));
  ends_ = get("ends_on_success") != 0;
  start_ = static_cast<Start>(get("start"));
  success_posture_ = get("success");
  posture_weight_ = get("posture_weight");
  control_weight_ = get("control_weight");
  pose_noise_ = get("pose_noise");
  settle_steps_ = static_cast<int>(get("settle_steps"));
}

void Rollover::reset(engine::Physics& physics, Random& random) {
  from_belly_ = start_ == kDrawn ? random.uniform() < 0.5 : start_ == kBelly;
  if (from_belly_) turn_over(physics);
  for (const body::Joint& joint : body_.joints) {
    physics.data().qpos[joint.qpos] += random.uniform(-pose_noise_, pose_noise_);
  }
  physics.step(settle_steps_);
}

// From the back onto the belly: half a turn about the long axis, z, and the lowest point where it was.
void Rollover::turn_over(engine::Physics& physics) const {
  const auto lowest = [&] {
    physics.update_poses();
    return body::extent(physics.model(), physics.data(), body_).low;
  };
  const double on_back = lowest();
  double* root = physics.data().qpos + root_address_;
  const double w = root[3], x = root[4], y = root[5], z = root[6];
  root[3] = -z;
  root[4] = y;
  root[5] = -x;
  root[6] = w;
  root[2] += on_back - lowest();
}

// How far they have turned over: 0 as they lay, 1 the other way up. It is the angle between their fronts, x, and where
// these looked at the start, up or down, over half a turn.
double Rollover::posture(const mjData& data) const {
  double sum = 0;
  for (const int body : turning_) {
    const double up = data.xmat[9 * body + 6];
    sum += fixed::acos(std::clamp(from_belly_ ? -up : up, -1.0, 1.0)) / kPi;
  }
  return sum / static_cast<double>(turning_.size());
}

void Rollover::evaluate(const engine::Physics& physics) {
  const double turned = posture(physics.data());
  terms_[kPosture].value = posture_weight_ * turned;
  terms_[kControl].value = 0 - control_weight_ * squared_controls(physics, body_.actuators);  // not -0 at rest
  success_ = turned >= success_posture_;
}

void Rollover::save(ByteWriter& to) const {
  Task::save(to);
  to.put(from_belly_);
}

void Rollover::load(ByteReader& from) {
  Task::load(from);
  from_belly_ = from.take_flag();
}

}  // namespace

const Definition kRollover = {
    "rollover",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Rollover>(model, body, settings);
    }};

}  // namespace mimo::tasks
