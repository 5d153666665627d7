#include "sound/scrape.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

// Estimates: 40 dB at 1 m of two pieces of hardwood that are pressed together with 1 N and slide at 0.1 m/s.
constexpr double kPressure = 2e-3, kSpeedThen = 0.1, kEfficiencyThen = 1e-4, kRoughnessThen = 14.1e-6;
constexpr double kGrain = 5e-5;                 // m, from one height of the surface to the next
constexpr double kSpread = 1.7320508075688772;  // numbers from -1 to 1 times this have the mean square 1
constexpr double kMost = 1e15;                  // steps of the surface, that a state may hold

// The radius of the patch where they touch (Hertz), m.
double patch(const Struck& a, const Struck& b, double force, double curvature) {
  return fixed::cbrt(0.75 * force * (compliance(a.solid) + compliance(b.solid)) / curvature);
}

}  // namespace

ScrapeLevel scrape_level(const Struck& a, const Struck& b, const Sliding& sliding) {
  const double efficiency = std::max(a.solid.efficiency, b.solid.efficiency);
  if (sliding.speed <= kSlowestScrape || sliding.force <= 0 || efficiency <= 0) return {};
  const double rough = length_of(a.solid.roughness, b.solid.roughness);
  ScrapeLevel level;
  level.pressure = kPressure * sliding.speed / kSpeedThen * std::sqrt(sliding.force) * rough / kRoughnessThen *
                   std::sqrt(efficiency / kEfficiencyThen);
  const double curvature = a.curvature + b.curvature;
  if (sliding.rolls && curvature > 0) {
    // Waves of the surface that are shorter than the patch lift nothing.
    level.corner = sliding.speed / (2 * kPi * std::sqrt(patch(a, b, sliding.force, curvature) / curvature));
  }
  return level;
}

void ScrapeNoise::rest(std::uint64_t number) {
  *this = ScrapeNoise();
  number_ = number;
}

bool ScrapeNoise::sound(const ScrapeLevel& level, double speed, double rate, Span<float> out) {
  if (level.pressure == 0 && pressure_ == 0) return false;
  if (level.pressure > 0) {  // else it fades at the speed that it had
    speed_ = speed;
    corner_ = level.corner;
  }
  const double step = speed_ / (rate * kGrain), count = static_cast<double>(out.size());
  const double keeps = corner_ > 0 ? fixed::exp(-2 * kPi * corner_ / rate) : 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double whole = std::floor(distance_), share = distance_ - whole;
    const auto at = static_cast<std::uint64_t>(whole);
    // Between two heights, and no flatter in the middle.
    const double height = ((1 - share) * scattered(number_, at) + share * scattered(number_, at + 1)) /
                          std::sqrt((1 - share) * (1 - share) + share * share);
    smooth_ = (1 - keeps) * height + keeps * smooth_;
    const double gain = pressure_ + (level.pressure - pressure_) * static_cast<double>(i + 1) / count;
    out[i] = static_cast<float>(kSpread * gain * smooth_);
    distance_ += step;
  }
  pressure_ = level.pressure;
  return true;
}

void ScrapeNoise::save(ByteWriter& to) const {
  to.put(number_);
  for (const double number : {distance_, speed_, pressure_, smooth_, corner_}) to.put(number);
}

void ScrapeNoise::load(ByteReader& from) {
  number_ = from.take<std::uint64_t>();
  for (double* number : {&distance_, &speed_, &pressure_, &smooth_, &corner_}) *number = from.take_finite("a noise");
  require(distance_ >= 0 && distance_ < kMost && speed_ >= 0 && pressure_ >= 0 && corner_ >= 0,
          "the state holds a noise whose numbers are out of range");
}

}  // namespace mimo::sound
