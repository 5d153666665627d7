// Catching: a ball of random size and mass falls into the right hand, which is to hold it for a second.
#include "base/fail.h"
#include "engine/model.h"
#include "tasks/infant.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"catch/episode_steps", 800, 0, 1e9, "Steps after which an episode is cut off; 0: never"},
    {"catch/ends", 1, 0, 1, "1: success and failure end the episode"},
    {"catch/hold_steps", 100, 1, 1e9, "Success: the ball was touched in this many steps in a row"},
    {"catch/lost_below", 0.1, -1e3, 1e3, "Failure: the ball is more than this below the palm, m"},
    {"catch/lost_beyond", 0.5, 0, 1e3, "Failure: the ball is farther from the palm than this, m"},
    {"catch/contact_reward", 1, -1e9, 1e9, "Reward of a step in which the skin touches the ball"},
    {"catch/success_reward", 100, -1e9, 1e9, "Reward of success"},
    {"catch/failure_reward", -100, -1e9, 1e9, "Reward of failure"},
    {"catch/effort_weight", 40, -1e9, 1e9,
     "The effort of the actuation, 0 to 1, times this is subtracted from the reward"},
    {"catch/radius_low", 0.005, 1e-3, 0.1, "The ball's radius is drawn anew for each episode: smallest, m"},
    {"catch/radius_high", 0.025, 1e-3, 0.1, "largest, m"},
    {"catch/mass_low", 0.05, 1e-3, 10, "The ball's mass is drawn anew for each episode: smallest, kg"},
    {"catch/mass_high", 0.5, 1e-3, 10, "largest, kg"},
    {"catch/x_spread", 0.01, 0, 1,
     "The ball starts at most this far from its place in the scene, to the front and back, m"},
    {"catch/y_spread", 0.01, 0, 1, "to the sides, m"},
    {"catch/z_spread", 0.08, 0, 1, "up and down, m"},
    {"catch/settle_steps", 50, 0, 10000, "Physics steps without gravity and without commands before the ball falls"},
    {"catch/track_target", 1, 0, 1, "1: head and eyes follow the ball"},
    {"catch/jitter", 0, 0, 1,
     "Each action is multiplied by 1 plus or minus this at most, drawn anew every 10 to 50 steps"},
    {"catch/gaze_error", 0, 0, 1, "They look at most this far beside it along each axis, drawn for each episode, m"},
};

// Steps for which the factors of the actions stay.
constexpr std::uint64_t kJitterShortest = 10, kJitterLongest = 50;

class Catch : public Task {
 public:
  Catch(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics& physics, Random& random) override;
  Span<const float> disturb(Span<const float> actions, Random& random) override;
  void watch(const engine::Physics& physics) override { touched_ = touched_ || touches(physics, skin_, ball_); }
  void evaluate(const engine::Physics& physics) override;
  void follow(engine::Physics& physics) override;
  // Steps in a row in which the skin touches the ball: how many are a success, and how many there were.
  int goal_size() const override { return 1; }
  void goal(const mjData&, double* out) const override { *out = static_cast<double>(hold_steps_); }
  void achieved(const mjData&, double* out) const override { *out = static_cast<double>(held_); }
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;
  std::vector<observation::Signal> signals(const mjModel& model) const override;

 private:
  enum { kContact, kEffort, kFailure, kSuccess };

  void settle(engine::Physics& physics) const;
  bool lost(const engine::Physics& physics) const;

  int ball_, palm_;
  int ball_address_;  // in qpos
  std::vector<int> skin_;
  Tracking tracking_;
  std::uint64_t hold_steps_;
  double lost_below_, lost_beyond_, contact_reward_, success_reward_, failure_reward_, effort_weight_;
  double radius_low_, radius_high_, mass_low_, mass_high_, gaze_error_, jitter_;
  Eigen::Vector3d spread_;
  int settle_steps_;
  bool track_;
  // State of the episode.
  bool touched_ = false;
  std::uint64_t held_ = 0;  // steps in a row
  Eigen::Vector3d gaze_offset_ = Eigen::Vector3d::Zero();
  std::uint64_t jitter_seed_ = 0, jitter_left_ = 0;  // where the present factors come from, and for how many steps
  std::vector<float> disturbed_;
};

Catch::Catch(const mjModel& model, const body::Body& body, const Settings& settings)
    : Task({{"contact", 0}, {"effort", 0}, {"failure", 0}, {"success", 0}}),
      ball_(target_of(model, body, "catch", "a free ball")),
      palm_(engine::find_or_fail(model, engine::Kind::kBody, body.prefix + "right_hand")),
      ball_address_(engine::free_joint_address(model, ball_)),
      skin_(body::bodies_with_skin(model, body)),
      tracking_(model, body) {
  if (!engine::is_ball(model, ball_)) {
    fail(Status::kModel, "body {}target: catch needs a ball, a free body of one sphere", body.prefix);
  }
  const auto get = [&](const char* name) { return settings[std::string("catch/") + name]; };
  episode_steps_ = static_cast<std::uint64_t>(get("episode_steps"));
  ends_ = get("ends") != 0;
  hold_steps_ = static_cast<std::uint64_t>(get("hold_steps"));
  const double volume = body.arm * body.arm * body.arm;
  lost_below_ = body.arm * get("lost_below");
  lost_beyond_ = body.arm * get("lost_beyond");
  contact_reward_ = get("contact_reward");
  success_reward_ = get("success_reward");
  failure_reward_ = get("failure_reward");
  effort_weight_ = get("effort_weight");
  radius_low_ = body.arm * get("radius_low");
  radius_high_ = body.arm * get("radius_high");
  mass_low_ = volume * get("mass_low");
  mass_high_ = volume * get("mass_high");
  spread_ = body.arm * Eigen::Vector3d(get("x_spread"), get("y_spread"), get("z_spread"));
  settle_steps_ = static_cast<int>(get("settle_steps"));
  track_ = get("track_target") != 0;
  gaze_error_ = body.arm * get("gaze_error");
  jitter_ = get("jitter");
  disturbed_.reserve(2 * body.actuators.size());  // steps allocate nothing; a motor has two muscles at most
}

void Catch::reset(engine::Physics& physics, Random& random) {
  const double radius = random.uniform(radius_low_, radius_high_);
  const double mass = random.uniform(mass_low_, mass_high_);
  physics.shape_ball(ball_, radius, mass);
  double* place = physics.data().qpos + ball_address_;
  for (int axis = 0; axis < 3; ++axis) place[axis] += random.uniform(-spread_[axis], spread_[axis]);
  for (double& offset : gaze_offset_) offset = random.uniform(-gaze_error_, gaze_error_);
  settle(physics);
  physics.update_poses();
  if (track_) tracking_.look_at(position(physics, ball_) + gaze_offset_, physics);
  touched_ = false;
  held_ = 0;
  jitter_left_ = 0;
}

// The factors are kept as the seed that they are drawn from.
Span<const float> Catch::disturb(Span<const float> actions, Random& random) {
  if (jitter_ == 0) return actions;
  if (jitter_left_ == 0) {
    jitter_seed_ = random.next();
    jitter_left_ = kJitterShortest + random.next() % (kJitterLongest - kJitterShortest + 1);
  }
  --jitter_left_;
  Random factors(jitter_seed_);
  disturbed_.clear();
  for (const float action : actions) {
    disturbed_.push_back(action * static_cast<float>(factors.uniform(1 - jitter_, 1 + jitter_)));
  }
  return disturbed_;
}

// The pose is a sketch: weightless, it comes to rest where welds and locks want it.
void Catch::settle(engine::Physics& physics) const {
  const Eigen::Vector3d own = physics.gravity();
  physics.set_gravity(Eigen::Vector3d::Zero());
  physics.step(settle_steps_);
  physics.set_gravity(own);
}

bool Catch::lost(const engine::Physics& physics) const {
  const Eigen::Vector3d from_palm = position(physics, ball_) - position(physics, palm_);
  return from_palm.z() < -lost_below_ || from_palm.norm() > lost_beyond_;
}

void Catch::evaluate(const engine::Physics& physics) {
  held_ = touched_ ? held_ + 1 : 0;
  success_ = held_ >= hold_steps_;
  failure_ = !success_ && lost(physics);
  terms_[kContact].value = touched_ ? contact_reward_ : 0;
  terms_[kEffort].value = 0 - effort_weight_ * step_.effort;  // not -0 where nothing is done
  terms_[kFailure].value = failure_ ? failure_reward_ : 0;
  terms_[kSuccess].value = success_ ? success_reward_ : 0;
  touched_ = false;
}

void Catch::follow(engine::Physics& physics) {
  if (!track_) return;
  tracking_.look_at(position(physics, ball_) + gaze_offset_, physics);
  physics.update_poses_at_last_start(tracking_.joints());
}

// The infant knows how large the ball is.
std::vector<observation::Signal> Catch::signals(const mjModel& model) const {
  observation::Field field;
  field.name = "task/ball_radius";
  field.shape = {1};
  field.unit = "m";
  field.time = observation::Time::kEnd;
  field.low = 0;
  field.labels = {"radius"};
  const int geom = model.body_geomadr[ball_];
  return {{field, [geom](const mjModel& now, const mjData&, float* out) {
             *out = static_cast<float>(now.geom_size[3 * geom]);
           }}};
}

void Catch::save(ByteWriter& to) const {
  Task::save(to);
  to.put(touched_);
  to.put(held_);
  to.put(Span<const double>(gaze_offset_.data(), 3));
  to.put(jitter_seed_);
  to.put(jitter_left_);
}

void Catch::load(ByteReader& from) {
  Task::load(from);
  touched_ = from.take_flag();
  held_ = from.take<std::uint64_t>();
  for (double& offset : gaze_offset_) offset = from.take_finite("the gaze's error");
  jitter_seed_ = from.take<std::uint64_t>();
  jitter_left_ = from.take<std::uint64_t>();
}

}  // namespace

const Definition kCatch = {
    "catch",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Catch>(model, body, settings);
    }};

}  // namespace mimo::tasks
