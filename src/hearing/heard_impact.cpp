#include "hearing/heard_impact.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/functions.h"
#include "base/numbers.h"
#include "sound/air.h"

namespace mimo::hearing {
namespace {

using sound::kModes;

constexpr double kFallBy60 = 6.907755278982137;       // nepers
constexpr double kInaudible = sound::kReference / 2;  // Pa, of a mode: -6 dB, below the thresholds of all ages
constexpr double kTail = 64;                          // samples after which a filter is done with a click

}  // namespace

std::array<Eigen::Vector3d, kEars> ears_of_frame() {
  constexpr double kAzimuth = 100 * kDegree;
  const double forward = fixed::cos(kAzimuth), aside = fixed::sin(kAzimuth);
  return {Eigen::Vector3d(forward, aside, 0), Eigen::Vector3d(forward, -aside, 0)};
}

Ways ways_to(const Head& head, const Eigen::Vector3d& place) {
  const Eigen::Vector3d to = place - head.middle;
  const double distance = to.norm();
  Ways ways;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    const double cosine = distance > 0 ? head.ears[ear].dot(to) / distance : 0;
    ways[ear] = sound::way_to_ear(head.radius, distance, cosine);
  }
  return ways;
}

Voice::Voice(const Blow& blow, const Ways& ways, double rate) : rate_(rate), click_(blow.click), ways_(ways) {
  double end = 0;
  const sound::Ringing& ringing = blow.ringing;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    start_[ear] = blow.onset + ways[ear].delay * rate;
    if (click_.scale > 0) end = std::max(end, start_[ear] + click_.end() * rate + kTail);
  }
  for (std::size_t i = 0; i < ringing.count; ++i) {
    const sound::Mode& mode = ringing.modes[i];
    if (mode.frequency >= rate / 2) continue;
    const double decay = kFallBy60 / (mode.decay * rate);
    double loudest = 0;
    for (std::size_t ear = 0; ear < kEars; ++ear) {
      const std::complex<double> heard = mode.gain * ways[ear].gain * sound::response(ways[ear], mode.frequency);
      amplitude_[ear][modes_] = length_of(heard.real(), heard.imag());
      phase_[ear][modes_] = fixed::atan2(heard.imag(), heard.real());
      loudest = std::max(loudest, amplitude_[ear][modes_]);
    }
    if (loudest <= kInaudible) continue;
    turn_[modes_] = 2 * kPi * mode.frequency / rate;
    decay_[modes_] = decay;
    ++modes_;
    end = std::max(end, std::max(start_[0], start_[1]) + fixed::log(loudest / kInaudible) / decay);
  }
  end_ = static_cast<std::int64_t>(std::ceil(end));
  prepare();
}

void Voice::prepare() {
  for (std::size_t i = 0; i < modes_; ++i) {
    kept_[i] = fixed::exp(-decay_[i]);
    cosine_[i] = fixed::cos(turn_[i]);
    sine_[i] = fixed::sin(turn_[i]);
  }
}

double Voice::remains(std::int64_t now) const {
  double sum = 0;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    const double gone = std::max(0.0, static_cast<double>(now) - start_[ear]);
    for (std::size_t i = 0; i < modes_; ++i) {
      const double left = amplitude_[ear][i] * fixed::exp(-decay_[i] * gone);
      sum += left * left / (4 * decay_[i]);
    }
    if (click_.scale > 0 && gone < click_.end() * rate_)
      sum += square(ways_[ear].gain * click_.peak()) * click_.duration * rate_;
  }
  return sum;
}

void Voice::add(std::size_t ear, std::int64_t now, Span<float> out) {
  const std::int64_t first = std::max(now, static_cast<std::int64_t>(std::ceil(start_[ear])));
  if (first >= now + static_cast<std::int64_t>(out.size()) || !alive(now)) return;
  if (click_.scale > 0) add_click(ear, first, now, out);
  if (modes_ > 0) add_ringing(ear, first, now, out);
}

void Voice::add_click(std::size_t ear, std::int64_t first, std::int64_t now, Span<float> out) {
  const auto over = static_cast<std::int64_t>(start_[ear] + click_.end() * rate_ + kTail);
  const std::int64_t last = std::min(over, now + static_cast<std::int64_t>(out.size()));
  if (first >= last) return;
  const sound::ClickWave wave(click_);
  const sound::Coefficients c = sound::coefficients(ways_[ear], rate_);
  for (std::int64_t n = first; n < last; ++n) {
    const double gone = static_cast<double>(n) - start_[ear] - c.late;
    const auto in = static_cast<float>(ways_[ear].gain * wave.at(gone / rate_));
    out[static_cast<std::size_t>(n - now)] += filter_[ear].next(c, in);
  }
}

// Each mode is a recursion of two steps that starts anew with every call.
void Voice::add_ringing(std::size_t ear, std::int64_t first, std::int64_t now, Span<float> out) const {
  static_assert(kModes == 8);
  using Lanes = Eigen::Array<float, kModes, 1>;
  Lanes y2 = Lanes::Zero(), y1 = Lanes::Zero(), c1 = Lanes::Zero(), c2 = Lanes::Zero();
  const double gone = static_cast<double>(first) - start_[ear];
  std::size_t audible = 0;
  for (std::size_t i = 0; i < modes_; ++i) {
    const double left = amplitude_[ear][i] * fixed::exp(-decay_[i] * gone);
    if (left < kInaudible) continue;
    const double angle = turn_[i] * gone + phase_[ear][i], s = fixed::sin(angle), c = fixed::cos(angle);
    // The two samples before, by the sines of angles that are one and two turns less.
    const double once = s * cosine_[i] - c * sine_[i];
    const double twice = once * cosine_[i] - (c * cosine_[i] + s * sine_[i]) * sine_[i];
    const double before = left / kept_[i];
    y1[audible] = static_cast<float>(before * once);
    y2[audible] = static_cast<float>(before / kept_[i] * twice);
    c1[audible] = static_cast<float>(2 * kept_[i] * cosine_[i]);
    c2[audible] = static_cast<float>(kept_[i] * kept_[i]);
    ++audible;
  }
  if (audible == 0) return;
  for (std::size_t n = static_cast<std::size_t>(first - now); n < out.size(); ++n) {
    const Lanes y = c1 * y1 - c2 * y2;
    const Eigen::Array4f pairs = y.head<4>() + y.tail<4>();  // in one order, which sum() has not on all processors
    out[n] += (pairs[0] + pairs[2]) + (pairs[1] + pairs[3]);
    y2 = y1;
    y1 = y;
  }
}

template <typename Self, typename Visit>
void Voice::visit(Self& self, Visit&& visit) {
  visit(self.rate_);
  for (double* number : {&self.click_.duration, &self.click_.scale, &self.click_.settling}) visit(*number);
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    sound::Way& way = self.ways_[ear];
    sound::SphereFilter& filter = way.filter;
    for (double* number : {&self.start_[ear], &way.gain, &way.size}) visit(*number);
    for (double* number : {&filter.b1, &filter.b2, &filter.a1, &filter.a2, &filter.still}) visit(*number);
    for (std::size_t i = 0; i < kModes; ++i) {
      visit(self.amplitude_[ear][i]);
      visit(self.phase_[ear][i]);
    }
  }
  for (std::size_t i = 0; i < kModes; ++i) {
    visit(self.turn_[i]);
    visit(self.decay_[i]);
  }
}

void Voice::save(ByteWriter& to) const {
  to.put(end_);
  to.put(modes_);
  for (const sound::Filter& filter : filter_) filter.save(to);
  Voice copy = *this;
  visit(copy, [&](double number) { to.put(number); });
}

void Voice::load(ByteReader& from) {
  end_ = from.take<std::int64_t>();
  modes_ = from.take<std::uint64_t>();
  require(modes_ <= kModes, "the state holds {} modes of a sound, expected up to {}", modes_, kModes);
  for (sound::Filter& filter : filter_) filter.load(from);
  visit(*this, [&](double& number) { number = from.take_finite("a sound"); });
  bool sane = rate_ > 0 && click_.settling > 0 && click_.duration >= 0;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    sane = sane && start_[ear] > -1e15 && start_[ear] < 1e15 && sound::can_be(ways_[ear]);
  }
  require(sane, "the state holds a sound that cannot be");
  prepare();
}

}  // namespace mimo::hearing
