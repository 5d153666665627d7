// Reaching: a ball floats before the infant, who looks at it and is to touch it with the right hand or arm.
#include <algorithm>

#include "engine/model.h"
#include "tasks/infant.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"reach/episode_steps", 1000, 0, 1e9, "Steps after which an episode is cut off; 0: never"},
    {"reach/ends_on_success", 1, 0, 1, "1: success ends the episode"},
    {"reach/original_rules", 0, 0, 1,
     "1: success is a target that was moved, by anything, and the distance is subtracted then as well"},
    {"reach/success_displacement", 0.01, 0, 10, "Original rules: how far the target must have been moved, m"},
    {"reach/success_reward", 100, -1e9, 1e9, "Reward of success"},
    {"reach/distance_weight", 1, -1e9, 1e9,
     "The distance of right fingers and target, m, times this is subtracted from the reward"},
    {"reach/track_target", 1, 0, 1, "1: head and eyes follow the target"},
    {"reach/warm_up_steps", 10, 0, 10000, "Physics steps with random motor commands at the start of an episode"},
    {"reach/target_x_low", -0.1, -10, 10, "The target's place is drawn around the scene's: lowest x, m"},
    {"reach/target_x_high", 0, -10, 10, "highest x, m"},
    {"reach/target_y_low", -0.2, -10, 10, "lowest y, m"},
    {"reach/target_y_high", 0.1, -10, 10, "highest y, m"},
    {"reach/target_z_low", -0.1, -10, 10, "lowest z, m"},
    {"reach/target_z_high", 0, -10, 10, "highest z, m"},
};

class Reach : public Task {
 public:
  Reach(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics& physics, Random& random) override;
  void watch(const engine::Physics& physics) override { touched_ = touched_ || touches(physics, arm_, target_); }
  void evaluate(const engine::Physics& physics) override;
  void follow(engine::Physics& physics) override;
  // Where the target is, and where the right fingers are.
  int goal_size() const override { return 3; }
  void goal(const mjData& data, double* out) const override { put(position(data, target_), out); }
  void achieved(const mjData& data, double* out) const override { put(center(data, fingers_), out); }
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  enum { kDistance, kSuccess };

  void warm_up(engine::Physics& physics, Random& random);
  void place_target(engine::Physics& physics, Random& random);
  bool reached(const engine::Physics& physics) const;

  int target_;
  std::vector<int> fingers_;
  int target_address_;  // in qpos
  std::vector<int> arm_;
  std::vector<int> motors_;
  Tracking tracking_;
  bool original_rules_, track_;
  double success_displacement_, success_reward_, distance_weight_;
  int warm_up_steps_;
  Eigen::Vector3d low_, high_;
  // State of the episode.
  bool touched_ = false;
  Eigen::Vector3d target_start_ = Eigen::Vector3d::Zero();
};

Reach::Reach(const mjModel& model, const body::Body& body, const Settings& settings)
    : Task({{"distance", 0}, {"success", 0}}),
      target_(target_of(model, body, "reach", "which the right hand is to touch")),
      fingers_(body::right_fingers(model, body)),
      target_address_(engine::free_joint_address(model, target_)),
      arm_(body::subtree(model, engine::find_or_fail(model, engine::Kind::kBody, body.prefix + "right_upper_arm"))),
      motors_(body.actuators),
      tracking_(model, body) {
  const auto get = [&](const char* name) { return settings[std::string("reach/") + name]; };
  episode_steps_ = static_cast<std::uint64_t>(get("episode_steps"));
  ends_ = get("ends_on_success") != 0;
  original_rules_ = get("original_rules") != 0;
  track_ = get("track_target") != 0;
  success_displacement_ = get("success_displacement");
  success_reward_ = get("success_reward");
  distance_weight_ = get("distance_weight");
  warm_up_steps_ = static_cast<int>(get("warm_up_steps"));
  low_ = body.arm * Eigen::Vector3d(get("target_x_low"), get("target_y_low"), get("target_z_low"));
  high_ = body.arm * Eigen::Vector3d(get("target_x_high"), get("target_y_high"), get("target_z_high"));
}

void Reach::reset(engine::Physics& physics, Random& random) {
  warm_up(physics, random);
  place_target(physics, random);
  physics.update_poses();
  if (track_) tracking_.look_at(position(physics, target_), physics);
  target_start_ = position(physics, target_);
  touched_ = false;
}

// A little movement, so that no two episodes start alike.
void Reach::warm_up(engine::Physics& physics, Random& random) {
  const mjModel& model = physics.model();
  mjData& data = physics.data();
  for (int step = 0; step < warm_up_steps_; ++step) {
    for (const int motor : motors_) {
      const double* range = model.actuator_forcerange + 2 * motor;
      data.ctrl[motor] = random.uniform(range[0], range[1]);
    }
    physics.step(1);
    if (track_) tracking_.look_at(position(physics, target_), physics);
  }
  std::fill_n(data.ctrl, model.nu, 0.0);
  std::fill_n(data.qvel, model.nv, 0.0);
}

void Reach::place_target(engine::Physics& physics, Random& random) {
  double* place = physics.data().qpos + target_address_;
  for (int axis = 0; axis < 3; ++axis) place[axis] += random.uniform(low_[axis], high_[axis]);
}

void Reach::save(ByteWriter& to) const {
  Task::save(to);
  to.put(touched_);
  to.put(Span<const double>(target_start_.data(), 3));
}

void Reach::load(ByteReader& from) {
  Task::load(from);
  touched_ = from.take_flag();
  for (double& coordinate : target_start_) coordinate = from.take_finite("the target's place");
}

bool Reach::reached(const engine::Physics& physics) const {
  if (!original_rules_) return touched_;
  return (position(physics, target_) - target_start_).norm() > success_displacement_;
}

void Reach::evaluate(const engine::Physics& physics) {
  success_ = reached(physics);
  touched_ = false;
  const double distance = (center(physics, fingers_) - position(physics, target_)).norm();
  terms_[kDistance].value = success_ && !original_rules_ ? 0 : -distance_weight_ * distance;
  terms_[kSuccess].value = success_ ? success_reward_ : 0;
}

void Reach::follow(engine::Physics& physics) {
  if (!track_) return;
  tracking_.look_at(position(physics, target_), physics);
  physics.update_poses_at_last_start(tracking_.joints());
}

}  // namespace

const Definition kReach = {
    "reach",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Reach>(model, body, settings);
    }};

}  // namespace mimo::tasks
