// The way of a sound from a point to an ear on a rigid sphere: delay, and a filter of one pole and one zero.
#pragma once

#include <array>
#include <complex>
#include <cstddef>

namespace mimo::sound {

// H(s) = (1 + alpha s/(gamma w0)) / (1 + s/(gamma w0)) exp(-s tau/w0), w0 = speed of sound / radius: what a far source
// gives at an ear, relative to free air at the middle of the sphere.
struct SphereFilter {
  double alpha, gamma, tau;
};

constexpr std::size_t kSphereAngles = 37;  // every 5 degrees between ear and source
extern const std::array<SphereFilter, kSphereAngles> kSphereTable;

// Between the table's angles in straight lines. The angle is in radians, 0 to pi.
SphereFilter sphere_filter(double angle);

// From a source to an ear.
struct Way {
  double delay = 0;              // s
  double gain = 0;               // of what the source gives at 1 m
  double alpha = 1, corner = 1;  // of the filter; corner is gamma w0, 1/s
};

// `radius` of the head; the source is `distance` m from its middle, `cosine` of the angle between it and the ear. What
// is nearer than 1.05 radii counts as there.
Way way_to_ear(double radius, double distance, double cosine);

// The filter at a frequency in hertz.
std::complex<double> response(const Way& way, double frequency);

// The filter for samples, by the bilinear transform: y = b0 x + b1 x' - a1 y'.
struct Coefficients {
  float b0 = 0, b1 = 0, a1 = 0;
};
Coefficients coefficients(const Way& way, double rate);

}  // namespace mimo::sound
