// The four kinds of touch afferents of a patch of skin: SA1 tells how deep it is pressed, RA how fast that changes, PC
// how it is jolted, SA2 how it is stretched. Rates are means of the afferents there.
//
// Rates of SA1, RA and PC are fitted to TouchSim (Saal, Delhaye, Rayhaun and Bensmaia 2017, PNAS 114:E5693), a model of
// monkey and human afferents of the fingertip; SA2, and how deep a force presses, are estimates.
#pragma once

namespace mimo::receptors {

constexpr double kMillimetre = 1e-3;

// How deep skin gives way to a force, m: it stiffens. `spacing` is that of the patches, m: a wider one carries more.
double indentation(double force, double spacing);
// How far it is pulled aside.
double stretch(double force, double spacing);

// Depth in m, its rate in m/s, and the rate's change in m/s^2. Hz.
double sa1_rate(double depth, double speed);
double ra_rate(double speed);
double pc_rate(double acceleration);
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
