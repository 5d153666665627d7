// What becomes of an agent's actions on their way to its motors: weaker, noisy, late.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "actuation/actuation.h"
#include "base/bytes.h"
#include "observation/limited_field.h"

namespace mimo::actuation {

// Limits of some motors.
struct MotorLimits {
  std::string path;                                        // as the user wrote it
  std::function<bool(const std::string& action)> concern;  // by its name, without the agent's
  observation::Limits limits;
};

class MotorPath {
 public:
  // Null where nothing is limited. `prefix` is that of the actions' names; `natural` is how late each is without
  // limits, in seconds, empty where none is. Where several limits concern an action, the last one counts. Throws
  // Status::kNotFound for limits that concern none.
  static std::unique_ptr<MotorPath> make(const Actuation& actuation, const std::string& prefix,
                                         const std::vector<MotorLimits>& limits, const std::vector<double>& natural,
                                         const observation::Clock& clock);

  // Nothing is on its way.
  void forget();
  // At the start of a step of an episode whose noise has that seed: actions set out. Without any, nothing new does.
  void send(Span<const float> actions, std::uint64_t episode, std::uint64_t step);
  // What arrives at this tick of the episode, for the step that begins with it or is under way; what is no number
  // leaves its motor as it is. Empty where nothing arrives; lasts until the next call.
  Span<const float> arrive(std::uint64_t tick);

  bool late() const { return late_; }
  // What is on its way, for a path that is late. This object outlives it.
  Section section(std::string name);

 private:
  // The way of one action.
  struct Way {
    observation::Limits limits;
    std::size_t delay = 0;  // ticks
  };

  MotorPath(const Actuation& actuation, std::vector<Way> ways, std::size_t per_step);
  float limited(std::size_t action, float value, std::uint64_t episode, std::uint64_t step) const;
  float* row(std::uint64_t step) { return sent_.data() + step % rows_ * ways_.size(); }

  const Actuation& actuation_;
  std::vector<Way> ways_;
  std::size_t per_step_;  // ticks
  std::size_t rows_ = 1;
  bool late_ = false;
  std::vector<float> sent_;  // the last steps, one row each
  std::vector<float> arrived_;
};

}  // namespace mimo::actuation
