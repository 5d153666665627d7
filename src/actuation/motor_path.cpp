#include "actuation/motor_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bytes.h"
#include "base/fail.h"
#include "base/format.h"
#include "base/numbers.h"
#include "base/random.h"

namespace mimo::actuation {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();  // was sent

std::string without(const std::string& prefix, const std::string& name) {
  return begins_with(name, prefix) ? name.substr(prefix.size()) : name;
}

}  // namespace

std::unique_ptr<MotorPath> MotorPath::make(const Actuation& actuation, const std::string& prefix,
                                           const std::vector<MotorLimits>& limits, const std::vector<double>& natural,
                                           const observation::Clock& clock) {
  std::vector<std::string> names;
  for (const std::string& name : actuation.names()) names.push_back(without(prefix, name));
  std::vector<Way> ways(names.size());
  for (std::size_t i = 0; i < natural.size(); ++i) ways[i].delay = steps_of_delay(natural[i], clock.tick);
  for (const MotorLimits& some : limits) {
    bool found = some.path.empty();  // all, of which there may be none
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!some.concern(names[i])) continue;
      ways[i] = {some.limits, steps_of_delay(some.limits.delay, clock.tick)};
      found = true;
    }
    if (!found) {
      fail(Status::kNotFound, "limits: no motor \"{}\"; the agent has: {}", some.path, join(names, ", "));
    }
  }
  const bool any =
      std::any_of(ways.begin(), ways.end(), [](const Way& way) { return way.limits.any() || way.delay > 0; });
  return any ? std::unique_ptr<MotorPath>(new MotorPath(actuation, std::move(ways), clock.per_step)) : nullptr;
}

MotorPath::MotorPath(const Actuation& actuation, std::vector<Way> ways, std::size_t per_step)
    : actuation_(actuation), ways_(std::move(ways)), per_step_(per_step), arrived_(ways_.size()) {
  for (const Way& way : ways_) {
    rows_ = std::max(rows_, way.delay / per_step + 1);
    late_ = late_ || way.delay > 0;
  }
  sent_.resize(rows_ * ways_.size());
  forget();
}

void MotorPath::forget() { std::fill(sent_.begin(), sent_.end(), kNothing); }

void MotorPath::send(Span<const float> actions, std::uint64_t episode, std::uint64_t step) {
  float* now = row(step);
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    now[i] = actions.empty() ? kNothing : limited(i, actions[i], episode, step);
  }
}

// A delay ends within a step as well; what sets out then was sent with the steps before.
Span<const float> MotorPath::arrive(std::uint64_t tick) {
  bool any = false;
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    const std::uint64_t delay = ways_[i].delay;
    const bool now = tick >= delay && (tick - delay) % per_step_ == 0;
    arrived_[i] = now ? row((tick - delay) / per_step_)[i] : kNothing;
    any = any || !std::isnan(arrived_[i]);
  }
  return any ? Span<const float>(arrived_) : Span<const float>();
}

// Clipped before and after: noise does not lead beyond what a motor can do.
float MotorPath::limited(std::size_t action, float value, std::uint64_t episode, std::uint64_t step) const {
  const observation::Limits& limits = ways_[action].limits;
  const float low = actuation_.low()[action], high = actuation_.high()[action];
  double changed = limits.gain * static_cast<double>(std::clamp(value, low, high));
  if (limits.noisy()) {
    changed += limits.deviation(changed) * Noise(noise_seed(episode, step, actuation_.names()[action])).next();
  }
  constexpr double kLargest = std::numeric_limits<float>::max();
  const double least = std::max(static_cast<double>(low), -kLargest);
  const double most = std::min(static_cast<double>(high), kLargest);
  return static_cast<float>(std::clamp(changed, least, most));
}

Section MotorPath::section(std::string name) {
  Hash kind;
  kind.add(std::uint64_t{per_step_});
  for (const Way& way : ways_) kind.add(std::uint64_t{way.delay});
  Section section;
  section.name = std::move(name);
  section.kind = kind.value();
  section.essential = false;
  section.save = [this](ByteWriter& to) { to.put(Span<const float>(sent_)); };
  section.load = [this](ByteReader& from) {
    from.take(Span<float>(sent_));
    for (const float value : sent_) {
      require(!std::isinf(value), "the state holds {} for a command, expected a finite number", value);
    }
  };
  section.forget = [this] { forget(); };
  return section;
}

}  // namespace mimo::actuation
