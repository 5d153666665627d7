#include "reflexes/arc.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mimo::reflexes {
namespace {

std::int32_t ticks(double seconds, double tick) { return static_cast<std::int32_t>(std::lround(seconds / tick)); }

}  // namespace

Arc::Arc(const Rule& rule, std::size_t latency, double tick)
    : rule_(rule),
      latency_(static_cast<std::int32_t>(latency)),
      hold_(ticks(kRise + rule.hold, tick)),
      gone_after_(ticks(kGone, tick)),
      forgotten_after_(ticks(kRecovered, tick)),
      tick_(tick) {}

void Arc::rest() {
  on_ = false;
  gone_ = left_ = ticks_ = 0;
  due_ = since_ = kNone;
  level_ = 0;
  strength_ = fresh_ = 1;
}

void Arc::advance(double stimulus) {
  if (since_ != kNone && ++since_ >= forgotten_after_) {
    since_ = kNone;
    fresh_ = 1;
  }
  notice(stimulus);
  if (due_ == 0) begin();
  if (due_ != kNone) --due_;
  if (left_ > 0) {
    --left_;
    level_ = std::min(1.0, level_ + tick_ / kRise);
  } else {
    level_ = std::max(0.0, level_ - tick_ / rule_.decay);
  }
  if (level_ > 0 && ticks_ < std::numeric_limits<std::int32_t>::max()) ++ticks_;
}

// News that the stimulus of a tonic reflex is gone takes as long as that it has come.
void Arc::notice(double stimulus) {
  const bool felt = stimulus >= (on_ ? rule_.release : 1);
  if (!felt) {
    if (on_ && ++gone_ >= gone_after_) on_ = false;
    return;
  }
  gone_ = 0;
  if (!on_ && !busy()) trigger();
  on_ = true;
  if (rule_.tonic && due_ == kNone) left_ = std::max(left_, latency_ + 1);
}

void Arc::trigger() {
  const double seconds = static_cast<double>(since_) * tick_;
  if (since_ != kNone) fresh_ = seconds < kSoon ? fresh_ * kHabituation : recovered();
  since_ = 0;
  if (due_ == kNone) due_ = latency_;
}

double Arc::recovered() const {
  const double share = (static_cast<double>(since_) * tick_ - kSoon) / (kRecovered - kSoon);
  return fresh_ + (1 - fresh_) * std::clamp(share, 0.0, 1.0);
}

void Arc::begin() {
  left_ = std::max(left_, hold_);
  ticks_ = 0;
  strength_ = fresh_;
}

void Arc::save(ByteWriter& to) const {
  to.put(on_);
  for (const std::int32_t number : {gone_, due_, left_, ticks_, since_}) to.put(number);
  for (const double number : {level_, strength_, fresh_}) to.put(number);
}

void Arc::load(ByteReader& from) {
  on_ = from.take_flag();
  const auto take_ticks = [&](std::int32_t least) {
    const auto number = from.take<std::int32_t>();
    require(number >= least, "the state holds {} ticks for a reflex, expected {} or more", number, least);
    return number;
  };
  gone_ = take_ticks(0);
  due_ = take_ticks(kNone);
  left_ = take_ticks(0);
  ticks_ = take_ticks(0);
  since_ = take_ticks(kNone);
  for (double* number : {&level_, &strength_, &fresh_}) {
    *number = from.take_finite("a reflex");
    require(*number >= 0 && *number <= 1, "the state holds {} for a reflex, expected 0 to 1", *number);
  }
}

}  // namespace mimo::reflexes
