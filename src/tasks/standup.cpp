// Standing up: the infant squats in a crib with its hands on the rail, and is to get its head up with little effort.
#include <algorithm>

#include "tasks/infant.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"standup/episode_steps", 500, 0, 1e9, "Steps after which an episode is cut off; 0: never"},
    {"standup/ends_on_success", 0, 0, 1, "1: success ends the episode"},
    {"standup/success_height", 0.5, -100, 100, "Success: the head is at this height or above, m"},
    {"standup/base_height", 0.2, -100, 100, "The head's height is rewarded from here on, m"},
    {"standup/height_weight", 1, -1e9, 1e9, "Reward of a metre of height"},
    {"standup/control_weight", 0.01, -1e9, 1e9,
     "The sum of the squared control inputs times this is subtracted from the reward"},
    {"standup/pose_noise", 0.01, 0, 1, "Every joint starts at most this far from the stored pose, rad"},
    {"standup/settle_steps", 100, 0, 10000, "Physics steps without control at the start of an episode"},
};

class Standup : public Task {
 public:
  Standup(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics& physics, Random& random) override;
  void evaluate(const engine::Physics& physics) override;
  // Heights of the head: where it is a success, and where it is.
  int goal_size() const override { return 1; }
  void goal(const mjData&, double* out) const override { *out = success_height_; }
  void achieved(const mjData& data, double* out) const override { *out = position(data, head_).z(); }

 private:
  enum { kHeight, kControl };

  int head_;
  std::vector<body::Joint> joints_;
  std::vector<int> motors_;
  double success_height_, base_height_, height_weight_, control_weight_, pose_noise_;
  int settle_steps_;
};

Standup::Standup(const mjModel&, const body::Body& body, const Settings& settings)
    : Task({{"height", 0}, {"control", 0}}), head_(body.head), joints_(body.joints), motors_(body.actuators) {
  const auto get = [&](const char* name) { return settings[std::string("standup/") + name]; };
  episode_steps_ = static_cast<std::uint64_t>(get("episode_steps"));
  ends_ = get("ends_on_success") != 0;
  success_height_ = body.stature * get("success_height");
  base_height_ = body.stature * get("base_height");
  height_weight_ = get("height_weight");
  control_weight_ = get("control_weight");
  pose_noise_ = get("pose_noise");
  settle_steps_ = static_cast<int>(get("settle_steps"));
}

void Standup::reset(engine::Physics& physics, Random& random) {
  for (const body::Joint& joint : joints_) physics.data().qpos[joint.qpos] += random.uniform(-pose_noise_, pose_noise_);
  physics.step(settle_steps_);
}

void Standup::evaluate(const engine::Physics& physics) {
  const double height = position(physics, head_).z();
  terms_[kHeight].value = height_weight_ * (height - base_height_);
  terms_[kControl].value = 0 - control_weight_ * squared_controls(physics, motors_);  // not -0 at rest
  success_ = height >= success_height_;
}

}  // namespace

const Definition kStandup = {
    "standup",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Standup>(model, body, settings);
    }};

}  // namespace mimo::tasks
