// Hand regard: the infant is to look at its hands. How often each eye was turned to each hand in the episode is known
// twice: as the competition BabyBench measures it, down the face, and right, along the camera's axis.
#include <algorithm>
#include <array>

#include "base/functions.h"
#include "base/numbers.h"
#include "engine/model.h"
#include "tasks/infant.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"handregard/episode_steps", 1000, 0, 1e9, "Steps after which an episode is cut off; 0: never"},
    {"handregard/angle", 15 * kDegree, 0, kPi, "An eye looks at a hand that is less than this beside its axis, rad"},
    {"handregard/view_reward", 0, -1e9, 1e9, "Reward of a step for each eye and each hand in its view"},
    {"handregard/settle_steps", 100, 0, 10000, "Physics steps without control at the start of an episode"},
    {"handregard/warm_up_steps", 10, 0, 10000, "Physics steps of random actions after that"},
};

constexpr std::size_t kPairs = 4;  // right eye: right hand, left hand; left eye: right hand, left hand

class Handregard : public Task {
 public:
  Handregard(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics&, Random&) override;
  Opening opening() const override { return opening_; }
  void evaluate(const engine::Physics& physics) override;
  // The episode's steps, and in how many of them an eye was turned to a hand: of each pair by the competition's
  // measure, then of each in the eye's view.
  int goal_size() const override { return 2 * kPairs; }
  void goal(const mjData&, double* out) const override { std::fill_n(out, 2 * kPairs, static_cast<double>(steps_)); }
  void achieved(const mjData&, double* out) const override { std::copy(regarded_.begin(), regarded_.end(), out); }
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  bool within(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis) const;

  std::array<int, 2> eyes_, hands_;  // bodies, right and left
  double angle_, view_reward_;
  Opening opening_;
  // State of the episode.
  std::array<std::uint64_t, 2 * kPairs> regarded_{};
  std::uint64_t steps_ = 0;
};

Handregard::Handregard(const mjModel& model, const body::Body& body, const Settings& settings) : Task({{"view", 0}}) {
  const auto find = [&](const char* name) {
    return engine::find_or_fail(model, engine::Kind::kBody, body.prefix + name);
  };
  eyes_ = {find("right_eye"), find("left_eye")};
  hands_ = {find("right_hand"), find("left_hand")};
  const auto get = [&](const char* name) { return settings[std::string("handregard/") + name]; };
  episode_steps_ = static_cast<std::uint64_t>(get("episode_steps"));
  angle_ = get("angle");
  view_reward_ = get("view_reward");
  opening_ = {static_cast<int>(get("settle_steps")), static_cast<int>(get("warm_up_steps"))};
}

void Handregard::reset(engine::Physics&, Random&) {
  regarded_.fill(0);
  steps_ = 0;
}

// A hand is where its body begins, at the wrist. An eye's camera looks along x; -z points down the face.
void Handregard::evaluate(const engine::Physics& physics) {
  const mjData& data = physics.data();
  std::size_t pair = 0;
  int in_view = 0;
  for (const int eye : eyes_) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(data.xmat + 9 * eye);
    for (const int hand : hands_) {
      const Eigen::Vector3d offset = position(data, hand) - position(data, eye);
      if (within(offset, -axes.col(2))) ++regarded_[pair];
      if (within(offset, axes.col(0))) {
        ++regarded_[kPairs + pair];
        ++in_view;
      }
      ++pair;
    }
  }
  steps_ = step_.number;
  terms_[0].value = view_reward_ * in_view;
}

// A hand where the axis begins is in no direction.
bool Handregard::within(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis) const {
  const double distance = offset.norm();
  return distance > 0 && fixed::acos(std::clamp(offset.dot(axis) / distance, -1.0, 1.0)) < angle_;
}

void Handregard::save(ByteWriter& to) const {
  Task::save(to);
  to.put(Span<const std::uint64_t>(regarded_));
  to.put(steps_);
}

void Handregard::load(ByteReader& from) {
  Task::load(from);
  from.take(Span<std::uint64_t>(regarded_));
  steps_ = from.take<std::uint64_t>();
}

}  // namespace

const Definition kHandregard = {
    "handregard",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Handregard>(model, body, settings);
    }};

}  // namespace mimo::tasks
