// The four kinds of touch afferents of a patch of skin: SA1 tells how deep it is pressed, RA how fast that changes, PC
// how it is jolted, SA2 how it is stretched. Rates are means of the afferents there.
//
// Rates of SA1, RA and PC are fitted to TouchSim (Saal, Delhaye, Rayhaun and Bensmaia 2017, PNAS 114:E5693), a model of
// monkey and human afferents of the fingertip; SA2, and how deep a force presses, are estimates.
#pragma once

#include <cmath>

namespace mimo::receptors {

constexpr double kMillimetre = 1e-3;

// Numbers are doubles, or Eigen's arrays of them: many are worked out at each step.

// How deep skin gives way to a force, m: it stiffens. `spacing` is that of the patches, m: a wider one carries more.
template <typename Number>
Number indentation(const Number& force, const Number& spacing) {
  using std::abs;
  const Number pressing = 0.5 * (force + abs(force));  // 0 where it pulls
  return 3 * kMillimetre * pressing / (pressing + 300 * spacing);
}
// How far it is pulled aside.
inline double stretch(double force, double spacing) { return 3 * kMillimetre * force / (force + 150 * spacing); }

// Depth in m, its rate in m/s, and the rate's change in m/s^2. Hz.
double sa1_rate(double depth, double speed);
double ra_rate(double speed);
// TouchSim gives 1.8 spikes for a press and a release at 20 mm/s, which set the 56 Hz for skin whose jolts are those of
// a first-order filter of 10 ms.
template <typename Number>
Number pc_rate(const Number& acceleration) {
  const Number square = acceleration * acceleration;
  return 56 * square / (1 + square);
}
// Of one of two perpendicular directions: stretch along it of `all`, m.
double sa2_rate(double along, double all);

// What slides: ridges `wavelength` apart and `amplitude` high, m.
struct Texture {
  double wavelength, amplitude;
};
// What sliding over a texture adds, Hz: one spike for each ridge that an afferent feels.
double ra_of_sliding(double speed, const Texture& texture);
double pc_of_sliding(double speed, const Texture& texture);

// Below this, in Hz, a dying envelope counts as silence.
constexpr double kSilent = 1;

}  // namespace mimo::receptors
