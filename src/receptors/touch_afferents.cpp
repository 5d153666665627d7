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

// Straight lines between the points' logarithms; beyond the table nothing is felt.
template <std::size_t kCount>
double threshold(const Threshold (&table)[kCount], double frequency) {
  if (frequency < table[0].frequency || frequency > table[kCount - 1].frequency) return HUGE_VAL;
  std::size_t i = 1;
  while (table[i].frequency < frequency) ++i;
  const Threshold &low = table[i - 1], &high = table[i];
  const double share = std::log(frequency / low.frequency) / std::log(high.frequency / low.frequency);
  return low.amplitude * std::pow(high.amplitude / low.amplitude, share);
}

// One spike a ridge above the threshold, none below half of it.
template <std::size_t kCount>
double of_sliding(const Threshold (&table)[kCount], double speed, const Texture& texture) {
  if (!(texture.wavelength > 0)) return 0;
  const double frequency = speed / texture.wavelength;
  const double over = texture.amplitude * 1e6 / threshold(table, frequency);
  return frequency * std::clamp(2 * over - 1, 0.0, 1.0);
}

double give(double force, double half_force) { return 3 * kMillimetre * force / (force + half_force); }

}  // namespace

double indentation(double force, double spacing) { return give(std::max(0.0, force), 300 * spacing); }
double stretch(double force, double spacing) { return give(force, 150 * spacing); }

double sa1_rate(double depth, double speed) {
  const double held = 48 * std::max(0.0, depth / kMillimetre - 0.08);
  return std::min(350.0, held + 4.5 * std::max(0.0, speed / kMillimetre));
}

double ra_rate(double speed) {
  const double over = std::max(0.0, std::abs(speed) / kMillimetre - 3);
  return 250 * over / (over + 60);
}

// TouchSim gives 1.8 spikes for a press and a release at 20 mm/s, which set the 56 Hz for skin whose jolts are those of
// a first-order filter of 10 ms.
double pc_rate(double acceleration) {
  const double square = acceleration * acceleration;
  return 56 * square / (1 + square);
}

double sa2_rate(double along, double all) {
  constexpr double kLeast = 0.3 * kMillimetre;
  if (all < kLeast) return 10;
  return std::max(0.0, 10 + 30 * along / kMillimetre);
}

double ra_of_sliding(double speed, const Texture& texture) { return of_sliding(kRa, speed, texture); }
double pc_of_sliding(double speed, const Texture& texture) { return of_sliding(kPc, speed, texture); }

}  // namespace mimo::receptors
