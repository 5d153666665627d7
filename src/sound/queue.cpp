#include "sound/queue.h"

#include <algorithm>
#include <cmath>

namespace mimo::sound {

void Queue::clear() {
  std::fill(ring_.begin(), ring_.end(), 0.0F);
  begin_ = 0;
  end_ = -kInTheAir;
}

std::size_t Queue::room(std::int64_t now) const {
  const std::int64_t waiting = std::max<std::int64_t>(end_ - now, 0);
  return ring_.size() - static_cast<std::size_t>(kInTheAir) - static_cast<std::size_t>(waiting);
}

void Queue::add(Span<const float> samples, std::int64_t now) {
  const auto size = static_cast<std::int64_t>(ring_.size());
  if (over(now)) {
    begin_ = end_ = now;
  }
  const auto put = [&](float value) { ring_[static_cast<std::size_t>(end_++ % size)] = value; };
  while (end_ < now) put(0);
  for (const float value : samples) put(value);
  begin_ = std::max(begin_, end_ - size);
}

void Queue::stop(std::int64_t now) { end_ = std::min(end_, std::max(now, begin_)); }

float Queue::sample(std::int64_t at) const {
  return at < begin_ || at >= end_ ? 0.0F : ring_[static_cast<std::size_t>(at) % ring_.size()];
}

void Queue::read(double first, Span<float> out, float gain, float last_gain) const {
  const double whole = std::floor(first);
  const auto x = static_cast<float>(first - whole);
  // Lagrange's cubic through the samples at -1, 0, 1 and 2.
  const float a = -x * (x - 1) * (x - 2) / 6, b = (x + 1) * (x - 1) * (x - 2) / 2, c = -(x + 1) * x * (x - 2) / 2,
              d = (x + 1) * x * (x - 1) / 6;
  const auto at = static_cast<std::int64_t>(whole);
  const float slope = (last_gain - gain) / static_cast<float>(out.size());
  float before = sample(at - 1), here = sample(at), next = sample(at + 1);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const float later = sample(at + 2 + static_cast<std::int64_t>(i));
    out[i] += (gain + slope * static_cast<float>(i + 1)) * (a * before + b * here + c * next + d * later);
    before = here;
    here = next;
    next = later;
  }
}

void Queue::save(ByteWriter& to) const {
  to.put(begin_);
  to.put(end_);
  to.put(Span<const float>(ring_.data(), ring_.size()));
}

void Queue::load(ByteReader& from) {
  begin_ = from.take<std::int64_t>();
  end_ = from.take<std::int64_t>();
  from.take(Span<float>(ring_.data(), ring_.size()));
  constexpr std::int64_t kMost = std::int64_t{1} << 60;  // so that no sum of such numbers overflows
  require(begin_ >= 0 && end_ >= -kInTheAir && end_ < kMost && end_ - begin_ <= static_cast<std::int64_t>(ring_.size()),
          "the state holds a sound from sample {} to {}", begin_, end_);
  for (const float value : ring_) require(std::isfinite(value), "the state holds a sound that is not finite");
}

}  // namespace mimo::sound
