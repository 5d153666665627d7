#include "receptors/touch_afferents.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mimo::receptors {
namespace {

// Amplitude, micrometres, at which half of TouchSim's afferents fire once a cycle of this frequency.
struct Threshold {
  double frequency, amplitude;
};
constexpr Threshold kRa[] = {{1, 1016}, {2, 517}, {5, 210},   {10, 107},  {20, 68},
                             {40, 68},  {60, 85}, {100, 134}, {150, 330}, {200, 1016}};
constexpr Threshold kPc[] = {{2, 1995},   {5, 413},   {10, 263},  {20, 68},   {40, 17.7}, {60, 14.1},
                             {100, 14.1}, {150, 5.7}, {200, 3.7}, {300, 1.9}, {400, 4.6}};

// The amplitude's share of the threshold, from a half to 1. Straight lines between the points' logarithms; beyond the
// table nothing is felt. What is clear from two points alone needs no logarithms.
template <std::size_t kCount>
double over_threshold(const Threshold (&table)[kCount], double frequency, double amplitude) {
  if (frequency < table[0].frequency || frequency > table[kCount - 1].frequency) return 0.5;
  std::size_t i = 1;
  while (table[i].frequency < frequency) ++i;
  const Threshold &low = table[i - 1], &high = table[i];
  if (amplitude >= std::max(low.amplitude, high.amplitude)) return 1;
  if (amplitude <= 0.5 * std::min(low.amplitude, high.amplitude)) return 0.5;
  const double share = std::log(frequency / low.frequency) / std::log(high.frequency / low.frequency);
  const double threshold = low.amplitude * std::pow(high.amplitude / low.amplitude, share);
  return std::clamp(amplitude / threshold, 0.5, 1.0);
}

// One spike a ridge above the threshold, none below half of it.
template <std::size_t kCount>
double of_sliding(const Threshold (&table)[kCount], double speed, const Texture& texture) {
  if (!(texture.wavelength > 0)) return 0;
  const double frequency = speed / texture.wavelength;
  return frequency * (2 * over_threshold(table, frequency, texture.amplitude * 1e6) - 1);
}

}  // namespace

double sa1_rate(double depth, double speed) {
  const double held = 48 * std::max(0.0, depth / kMillimetre - 0.08);
  return std::min(350.0, held + 4.5 * std::max(0.0, speed / kMillimetre));
}

double ra_rate(double speed) {
  const double over = std::max(0.0, std::abs(speed) / kMillimetre - 3);
  return 250 * over / (over + 60);
}

double sa2_rate(double along, double all) {
  constexpr double kLeast = 0.3 * kMillimetre;
  if (all < kLeast) return 10;
  return std::max(0.0, 10 + 30 * along / kMillimetre);
}

double ra_of_sliding(double speed, const Texture& texture) { return of_sliding(kRa, speed, texture); }
double pc_of_sliding(double speed, const Texture& texture) { return of_sliding(kPc, speed, texture); }

}  // namespace mimo::receptors
