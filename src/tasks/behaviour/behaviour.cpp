// A behaviour: the infant is to do what the scene's document measures. One task for all of them.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/fail.h"
#include "base/names.h"
#include "engine/model.h"
#include "engine/overrides.h"
#include "tasks/behaviour/measures.h"
#include "tasks/infant.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"behaviour/episode_seconds", 0, 0, 1e9, "Time after which an episode is cut off, s; 0: the scene's own"},
    {"behaviour/ends_on_success", 0, 0, 1, "1: success ends the episode"},
    {"behaviour/threshold", 0, -1e9, 1e9,
     "What the measure has to reach, in the scene's unit, of the body of 18 months; 0: the scene's own"},
    {"behaviour/hold_seconds", 0, 0, 1e9, "How long everything has to hold, s; 0: the scene's own"},
    {"behaviour/progress_weight", 1, -1e9, 1e9,
     "Reward of having come all the way, as the mean of the measure and the conditions"},
    {"behaviour/held_weight", 1, -1e9, 1e9, "Reward of each step in which everything holds"},
    {"behaviour/control_weight", 0.01, -1e9, 1e9,
     "The sum of the squared control inputs times this is subtracted from the reward"},
    {"behaviour/pose_noise", 0.01, 0, 1, "Every joint starts at most this far from the stored pose, rad"},
};

constexpr double kRounding = 1e-9;  // s; of a sum of many time steps

// The joint that phases hold.
struct StillJoint {
  int lock = -1;  // -1: none
  int address = 0;
};

class Behaviour : public Task {
 public:
  Behaviour(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics& physics, Random& random) override;
  void watch(const engine::Physics& physics) override;
  void evaluate(const engine::Physics& physics) override;
  void follow(engine::Physics& physics) override;
  // Thresholds of the measure and the conditions, and seconds for which all have to hold; their values, and the longest
  // time for which all have held.
  int goal_size() const override { return static_cast<int>(goals_.size()) + 1; }
  void goal(const mjData&, double* out) const override;
  void achieved(const mjData&, double* out) const override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  enum { kProgress, kHeld, kControl };

  void look(const engine::Physics& physics, double seconds);
  bool all_met() const;
  double progress() const;
  void keep_still(engine::Physics& physics);

  std::vector<body::Joint> joints_;
  std::vector<int> motors_;
  std::vector<Goal> goals_;
  std::vector<double> phases_;  // when each ends, s
  StillJoint still_;
  double hold_seconds_, episode_seconds_;
  double progress_weight_, held_weight_, control_weight_, pose_noise_;
  // State of the episode.
  std::vector<double> values_;  // of the goals
  std::vector<double> memory_;
  double time_ = 0, held_ = 0, longest_ = 0;  // seconds: of the episode, all goals met until now, and at most
  bool reached_ = false;                      // a success, since the last evaluation
};

Clauses clauses_of(const mjModel& model) {
  const std::string text = engine::custom_text(model, names::kReached);
  if (text.empty()) {
    fail(Status::kNotFound,
         "task \"behaviour\" needs a scene whose custom text \"{}\" says what is measured, as the built-in scene "
         "\"sit\" has it",
         names::kReached);
  }
  return read_clauses(text);
}

StillJoint still_joint_of(const mjModel& model, const body::Body& body) {
  const std::string name = engine::custom_text(model, names::kStillJoint);
  if (name.empty()) return {};
  int id = engine::find(model, engine::Kind::kJoint, (body.prefix + name).c_str());
  if (id < 0) id = engine::find_or_fail(model, engine::Kind::kJoint, name);
  const int lock = engine::find_lock(model, id);
  if (lock < 0) {
    fail(Status::kModel, "{}: joint \"{}\" has no equality of its own that could hold it", names::kStillJoint, name);
  }
  return {lock, model.jnt_qposadr[id]};
}

Behaviour::Behaviour(const mjModel& model, const body::Body& body, const Settings& settings)
    : Task({{"progress", 0}, {"held", 0}, {"control", 0}}),
      joints_(body.joints),
      motors_(body.actuators),
      still_(still_joint_of(model, body)) {
  const auto get = [&](const char* name) { return settings[std::string("behaviour/") + name]; };
  const auto set_or = [&](const char* name, double own) { return get(name) != 0 ? get(name) : own; };
  Clauses clauses = clauses_of(model);
  Clause& measure = clauses.all.front();
  measure.threshold = set_or("threshold", measure.threshold);
  // A threshold of a parameter may stand where progress began: then only reaching it counts.
  if (measure.from && !measure.leads_up()) measure.from.reset();
  const std::vector<double> phases = phase_seconds(engine::custom_numbers(model, names::kPhases));
  Maker maker(model, body, phases);
  for (const Clause& clause : clauses.all) goals_.push_back(maker.goal(clause));
  memory_.assign(maker.kept(), 0);
  values_.assign(goals_.size(), 0);
  for (const double seconds : phases) phases_.push_back(seconds + (phases_.empty() ? 0 : phases_.back()));
  hold_seconds_ = set_or("hold_seconds", clauses.seconds);
  episode_seconds_ = set_or("episode_seconds", tasks::episode_seconds(engine::custom_numbers(model, names::kSeconds)));
  ends_ = get("ends_on_success") != 0;
  progress_weight_ = get("progress_weight");
  held_weight_ = get("held_weight");
  control_weight_ = get("control_weight");
  pose_noise_ = get("pose_noise");
}

void Behaviour::reset(engine::Physics& physics, Random& random) {
  for (const body::Joint& joint : joints_) physics.data().qpos[joint.qpos] += random.uniform(-pose_noise_, pose_noise_);
  time_ = held_ = longest_ = 0;
  keep_still(physics);
  physics.forward();
  std::fill(memory_.begin(), memory_.end(), 0.0);
  look(physics, 0);
  reached_ = false;
}

// Every quantity looks exactly once at each moment: it counts.
void Behaviour::look(const engine::Physics& physics, double seconds) {
  time_ += seconds;
  const Moment now{physics.model(), physics.data(), seconds, time_, memory_};
  for (std::size_t i = 0; i < goals_.size(); ++i) values_[i] = goals_[i].quantity->look(now);
  const bool met = all_met();
  held_ = met ? held_ + seconds : 0;
  longest_ = std::max(longest_, held_);
  reached_ = reached_ || (met && held_ >= hold_seconds_ - kRounding);
}

bool Behaviour::all_met() const {
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    if (!goals_[i].met(values_[i])) return false;
  }
  return true;
}

double Behaviour::progress() const {
  double sum = 0;
  for (std::size_t i = 0; i < goals_.size(); ++i) sum += goals_[i].progress(values_[i]);
  return sum / static_cast<double>(goals_.size());
}

void Behaviour::watch(const engine::Physics& physics) { look(physics, physics.model().opt.timestep); }

void Behaviour::evaluate(const engine::Physics& physics) {
  terms_[kProgress].value = progress_weight_ * progress();
  terms_[kHeld].value = all_met() ? held_weight_ : 0;
  terms_[kControl].value = 0 - control_weight_ * squared_controls(physics, motors_);  // not -0 at rest
  success_ = std::exchange(reached_, false);
  cut_off_ = time_ >= episode_seconds_ - kRounding;
}

void Behaviour::follow(engine::Physics& physics) { keep_still(physics); }

// The first phase is still, the second moves, and so on.
void Behaviour::keep_still(engine::Physics& physics) {
  if (still_.lock < 0) return;
  const auto over = std::upper_bound(phases_.begin(), phases_.end(), time_) - phases_.begin();
  const double angle = physics.model().qpos0[still_.address];
  if (over % 2 == 0) {
    physics.hold(still_.lock, angle);
  } else {
    physics.release(still_.lock, angle);
  }
}

void Behaviour::goal(const mjData&, double* out) const {
  for (const Goal& goal : goals_) *out++ = goal.threshold;
  *out = hold_seconds_;
}

void Behaviour::achieved(const mjData&, double* out) const {
  *std::copy(values_.begin(), values_.end(), out) = longest_;
}

void Behaviour::save(ByteWriter& to) const {
  Task::save(to);
  for (const double number : values_) to.put(number);
  for (const double number : memory_) to.put(number);
  // A success that is not evaluated yet, for the infant was moved along a path, turns the time's sign.
  for (const double number : {reached_ ? -time_ : time_, held_, longest_}) to.put(number);
}

void Behaviour::load(ByteReader& from) {
  Task::load(from);
  for (double& number : values_) number = from.take_finite("what a behaviour measures");
  for (double& number : memory_) number = from.take_finite("what a behaviour remembers");
  for (double* number : {&time_, &held_, &longest_}) *number = from.take_finite("how long a behaviour lasted");
  reached_ = time_ < 0;
  time_ = std::abs(time_);
}

}  // namespace

const Definition kBehaviour = {
    "behaviour",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Behaviour>(model, body, settings);
    }};

}  // namespace mimo::tasks
