// Self-body knowledge: the infant sits cross-legged, is told a part of its body and is to touch it with its right hand.
#include <algorithm>

#include "base/fail.h"
#include "base/names.h"
#include "tasks/infant.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"selfbody/episode_steps", 500, 0, 1e9, "Steps after which an episode is cut off; 0: never"},
    {"selfbody/ends_on_success", 1, 0, 1, "1: success ends the episode"},
    {"selfbody/success_reward", 500, -1e9, 1e9, "Reward when the target body feels a force"},
    {"selfbody/distance_weight", 1, -1e9, 1e9,
     "Else, when the right fingers feel a force: their distance from the target body, m, times this is subtracted"},
    {"selfbody/no_touch_reward", -1, -1e9, 1e9, "Reward when neither feels anything"},
    {"selfbody/settle_steps", 25, 0, 10000,
     "Physics steps without control that lead from the stored pose to the start"},
};

class Selfbody : public Task {
 public:
  Selfbody(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics& physics, Random& random) override;
  void watch(const engine::Physics& physics) override;
  void evaluate(const engine::Physics& physics) override;
  // The target body and where it is; that body if it feels a force, else -1, and where the right fingers are.
  int goal_size() const override { return 4; }
  void goal(const mjData& data, double* out) const override;
  void achieved(const mjData& data, double* out) const override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;
  std::vector<observation::Signal> signals(const mjModel& model) const override;

 private:
  enum { kSuccess, kDistance, kNoTouch };

  void settle(engine::Physics& physics);

  std::vector<int> fingers_;
  std::vector<int> skin_;
  std::vector<std::size_t> candidates_;  // places in skin_
  double success_reward_, distance_weight_, no_touch_reward_;
  int settle_steps_;
  std::vector<double> settled_;  // room for reset
  // State of the episode.
  std::size_t target_;  // place in skin_
  bool target_felt_ = false, fingers_felt_ = false;
};

Selfbody::Selfbody(const mjModel& model, const body::Body& body, const Settings& settings)
    : Task({{"success", 0}, {"distance", 0}, {"no_touch", 0}}),
      fingers_(body::right_fingers(model, body)),
      skin_(body::bodies_with_skin(model, body)),
      settled_(static_cast<std::size_t>(model.nq)) {
  // The arm that touches has skin, but is no target.
  const auto arm =
      body::subtree(model, engine::find_or_fail(model, engine::Kind::kBody, body.prefix + "right_upper_arm"));
  for (std::size_t i = 0; i < skin_.size(); ++i) {
    if (std::find(arm.begin(), arm.end(), skin_[i]) == arm.end()) candidates_.push_back(i);
  }
  if (candidates_.empty()) fail(Status::kModel, "{}: only bodies of the right arm have skin", names::kTouch);
  target_ = candidates_.front();
  const auto get = [&](const char* name) { return settings[std::string("selfbody/") + name]; };
  episode_steps_ = static_cast<std::uint64_t>(get("episode_steps"));
  ends_ = get("ends_on_success") != 0;
  success_reward_ = get("success_reward");
  distance_weight_ = get("distance_weight");
  no_touch_reward_ = get("no_touch_reward");
  settle_steps_ = static_cast<int>(get("settle_steps"));
}

void Selfbody::reset(engine::Physics& physics, Random& random) {
  settle(physics);
  target_ = candidates_[static_cast<std::size_t>(random.uniform() * static_cast<double>(candidates_.size()))];
  target_felt_ = fingers_felt_ = false;
}

// The target as the infant is told it: one number for each body with skin, 1 for the target, 0 for all others.
std::vector<observation::Signal> Selfbody::signals(const mjModel& model) const {
  observation::Field field;
  field.name = "task/target";
  field.shape = {skin_.size()};
  field.time = observation::Time::kEnd;
  field.low = 0;
  field.high = 1;
  for (const int body : skin_) field.labels.emplace_back(engine::name(model, engine::Kind::kBody, body));
  return {{field, [this](const mjModel&, const mjData&, float* out) {
             std::fill_n(out, skin_.size(), 0.0f);
             out[target_] = 1;
           }}};
}

void Selfbody::goal(const mjData& data, double* out) const {
  out[0] = skin_[target_];
  put(position(data, skin_[target_]), out + 1);
}

void Selfbody::achieved(const mjData& data, double* out) const {
  out[0] = success_ ? skin_[target_] : -1;
  put(center(data, fingers_), out + 1);
}

void Selfbody::save(ByteWriter& to) const {
  Task::save(to);
  to.put(std::uint64_t{target_});
  to.put(target_felt_);
  to.put(fingers_felt_);
}

void Selfbody::load(ByteReader& from) {
  Task::load(from);
  const auto target = from.take<std::uint64_t>();
  require(target < skin_.size(), "the state's target is body {} of {}", target, skin_.size());
  target_ = target;
  target_felt_ = from.take_flag();
  fingers_felt_ = from.take_flag();
}

// The stored pose is a sketch: locks, couplings and gravity pull it to where the infant really sits, at rest.
void Selfbody::settle(engine::Physics& physics) {
  physics.step(settle_steps_);
  mjData& data = physics.data();
  std::copy_n(data.qpos, settled_.size(), settled_.data());
  physics.reset();
  std::copy(settled_.begin(), settled_.end(), data.qpos);
}

void Selfbody::watch(const engine::Physics& physics) {
  target_felt_ = target_felt_ || feels(physics, skin_[target_]);
  fingers_felt_ =
      fingers_felt_ || std::any_of(fingers_.begin(), fingers_.end(), [&](int body) { return feels(physics, body); });
}

void Selfbody::evaluate(const engine::Physics& physics) {
  success_ = target_felt_;
  const bool near = !success_ && fingers_felt_;
  const double distance = (center(physics, fingers_) - position(physics, skin_[target_])).norm();
  terms_[kSuccess].value = success_ ? success_reward_ : 0;
  terms_[kDistance].value = near ? -distance_weight_ * distance : 0;
  terms_[kNoTouch].value = success_ || near ? 0 : no_touch_reward_;
  target_felt_ = fingers_felt_ = false;
}

}  // namespace

const Definition kSelfbody = {
    "selfbody",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Selfbody>(model, body, settings);
    }};

}  // namespace mimo::tasks
