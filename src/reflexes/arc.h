// One reflex of one side: from a stimulus to how strongly it acts. The stimulus sets it off when it comes; after the
// latency it rises within 0.1 s, is held, and decays. One that comes back soon meets a weaker reflex.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "reflexes/table.h"

namespace mimo::reflexes {

// All estimated.
constexpr double kRise = 0.1;         // s
constexpr double kGone = 0.1;         // s that a stimulus is away before it can set off the reflex again
constexpr double kHabituation = 0.8;  // factor of each repeat
constexpr double kSoon = 10,
                 kRecovered = 30;  // s after a stimulus: until then a repeat counts; from then on all is new

class Arc {
 public:
  // The latency in ticks, a tick in seconds.
  Arc(const Rule& rule, std::size_t latency, double tick);

  // As if there had never been a stimulus.
  void rest();
  // A tick with a stimulus of that share of its threshold.
  void advance(double stimulus);

  // 0 to 1, with habituation, without age.
  double activation() const { return level_ * strength_; }
  // Since it began to act, s.
  double seconds() const { return static_cast<double>(ticks_) * tick_; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  static constexpr std::int32_t kNone = -1;

  void notice(double stimulus);
  // Whether it runs its course, in which nothing disturbs it.
  bool busy() const { return !rule_.tonic && left_ > 0; }
  void trigger();
  void begin();
  double recovered() const;

  const Rule& rule_;
  std::int32_t latency_, hold_, gone_after_, forgotten_after_;  // ticks
  double tick_;

  bool on_ = false;             // the stimulus is there
  std::int32_t gone_ = 0;       // ticks since it went
  std::int32_t due_ = kNone;    // ticks until it begins to act
  std::int32_t left_ = 0;       // ticks that it is still held
  std::int32_t ticks_ = 0;      // since it began to act
  std::int32_t since_ = kNone;  // ticks since the last stimulus came; none: long ago
  double level_ = 0;            // of the trapezoid
  double strength_ = 1;         // of what is going on
  double fresh_ = 1;            // what habituation had left when the last stimulus came
};

}  // namespace mimo::reflexes
