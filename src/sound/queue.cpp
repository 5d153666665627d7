#include "sound/queue.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/functions.h"
#include "base/numbers.h"

namespace mimo::sound {
namespace {

constexpr int kTaps = 2 * static_cast<int>(kAhead);
using Weights = std::array<float, kTaps>;

// Of the samples at -3 to 4, for what is at `x`, 0 to 1: a sinc under a raised cosine. Up to 5 kHz of 16 it loses less
// than 0.2 dB wherever that is, so that both ears lose the same.
Weights between_samples(double x) {
  std::array<double, kTaps> weights;
  double sum = 0;
  for (int k = 0; k < kTaps; ++k) {
    const double off = x + kTaps / 2 - 1 - k;
    const double sinc = std::abs(off) < 1e-9 ? 1 : fixed::sin(kPi * off) / (kPi * off);
    weights[static_cast<std::size_t>(k)] = sinc * (0.5 + 0.5 * fixed::cos(2 * kPi * off / (kTaps + 1)));
    sum += weights[static_cast<std::size_t>(k)];
  }
  Weights scaled;
  for (std::size_t k = 0; k < kTaps; ++k) scaled[k] = static_cast<float>(weights[k] / sum);
  return scaled;
}

}  // namespace

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
  const auto at = static_cast<std::int64_t>(whole);
  const auto count = static_cast<std::int64_t>(out.size());
  if (at + count + kTaps < begin_ || at - kTaps >= end_) return;
  const Weights weights = between_samples(first - whole);
  const float slope = (last_gain - gain) / static_cast<float>(out.size());
  std::array<float, kTaps> near;
  for (std::int64_t i = 0; i < kTaps - 1; ++i) near[static_cast<std::size_t>(i)] = sample(at - kTaps / 2 + 1 + i);
  for (std::int64_t i = 0; i < count; ++i) {
    near[kTaps - 1] = sample(at + kTaps / 2 + i);
    float sum = 0;
    for (std::size_t k = 0; k < kTaps; ++k) sum += weights[k] * near[k];
    out[static_cast<std::size_t>(i)] += (gain + slope * static_cast<float>(i + 1)) * sum;
    for (std::size_t k = 0; k + 1 < kTaps; ++k) near[k] = near[k + 1];
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
