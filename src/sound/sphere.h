// The way of a sound from a point to an ear on a rigid sphere: delay, and a filter of two poles and two zeros.
#pragma once

#include <array>
#include <complex>
#include <cstddef>

#include "base/bytes.h"

namespace mimo::sound {

// H(s) = (still + b1 s + b2 s^2) / (1 + a1 s + a2 s^2), s in units of the speed of sound over the radius: what a source
// gives at an ear beside its delay, relative to free air at the middle of the sphere. No filter where a2 is 0.
struct SphereFilter {
  double b1 = 0, b2 = 0, a1 = 0, a2 = 0;
  double still = 1;  // 1 of far sources
};

constexpr std::size_t kSphereAngles = 37;  // every 5 degrees between ear and source
extern const std::array<SphereFilter, kSphereAngles> kSphereTable;

// Between the table's angles in straight lines. The angle is in radians, 0 to pi.
SphereFilter sphere_filter(double angle);

// From a source to an ear.
struct Way {
  double delay = 0;  // s
  double gain = 0;   // of what the source gives at 1 m
  SphereFilter filter;
  double size = 0;  // s: radius over the speed of sound, which scales the filter
};

// `radius` of the head; the source is `distance` m from its middle, `cosine` of the angle between it and the ear. What
// is nearer than 1.05 radii counts as there.
Way way_to_ear(double radius, double distance, double cosine);

// Whether its filter is one that a head can have: for what a state holds.
bool can_be(const Way& way);

// The filter at a frequency in hertz.
std::complex<double> response(const Way& way, double frequency);

// The filter for samples: y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y'', of what comes `late` samples after the way's
// delay.
struct Coefficients {
  float b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
  double late = 0;
};
Coefficients coefficients(const Way& way, double rate);

// What the filter remembers of two samples.
class Filter {
 public:
  float next(const Coefficients& c, float in);

  void save(ByteWriter& to) const;
  // Throws Status::kInvalidArgument for what is larger than any sound.
  void load(ByteReader& from);

 private:
  float x_[2] = {0, 0}, y_[2] = {0, 0};
};

}  // namespace mimo::sound
