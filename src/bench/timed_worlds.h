// Worlds that are timed: one with all its senses as users run it, and one of nothing but physics.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "programs/joints.h"
#include "programs/world.h"

namespace cli {

// A world of nothing but physics, and how its time is sampled: what `mimo-bench` compares full worlds with.

using Actions = std::vector<std::vector<float>>;

Actions draw(RandomActions& random, std::size_t count);

// Seconds of many repetitions of one thing.
class StepTimes {
 public:
  explicit StepTimes(std::size_t room) { seconds_.reserve(room); }
  void add(double seconds) { seconds_.push_back(seconds); }
  const std::vector<double>& seconds() const { return seconds_; }
  double sum() const { return std::accumulate(seconds_.begin(), seconds_.end(), 0.0); }
  double mean() const { return seconds_.empty() ? 0 : sum() / static_cast<double>(seconds_.size()); }
  double median() const {
    if (seconds_.empty()) return 0;
    auto sorted = seconds_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }

 private:
  std::vector<double> seconds_;
};

// Nothing but physics steps, with the same motor commands. Muscles and targets are not commands of motors: under these
// it is steps without senses, actuation included.
class PhysicsWorld {
 public:
  PhysicsWorld(const WorldOptions& world, std::int32_t jacobian, std::size_t steps);

  void run(const Actions& actions);
  void warm_up(const Actions& actions);
  void forget() { times_ = StepTimes(0); }  // what was measured so far
  void go_to(const mimo::Env& other);       // where that one is; ours rounds otherwise, and contacts amplify it

  const mimo::Env& env() const { return env_; }
  const StepTimes& times() const { return times_; }

 private:
  void step(const std::vector<float>& action);

  mimo::Env env_;
  bool motors_;  // actions are their commands
  std::vector<std::int32_t> actuators_;
  mimo::Block nothing_;  // nothing is sensed, nothing rewarded
  mimo::Results unwanted_;
  StepTimes times_;
};

// A world with all its senses as users run it, step by step under the clock.

class SensingWorld {
 public:
  SensingWorld(const WorldOptions& options, std::size_t steps);

  // The first step of a world makes what later ones reuse; it is not measured.
  void warm_up(const Actions& actions);
  void run(const Actions& actions);
  void reset(std::uint64_t seed);

  const mimo::Env& env() const { return env_; }
  const StepTimes& times() const { return times_; }
  std::size_t contacts() const { return contacts_; }

 private:
  mimo::Env env_;
  mimo::Block block_;
  mimo::Results results_;
  StepTimes times_;
  std::size_t contacts_ = 0;
};

}  // namespace cli
