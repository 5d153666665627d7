// Two bodies meet: how long they touch, and what rings afterwards.
#pragma once

#include <array>

#include "sound/mode_tables.h"

namespace mimo::sound {

// What a thing is like that is struck.

// Of a material.
struct Solid {
  double young = 0;       // Pa
  double poisson = 0;     // ratio
  double efficiency = 0;  // share of a blow's energy that ringing gives to the air; 0: it does not ring
  int timbre = -1;        // row of kTimbreTable; -1: it does not ring
  double roughness = 0;   // height of its texture, m
};

// By how much a material gives way.
inline double compliance(const Solid& solid) { return (1 - solid.poisson * solid.poisson) / solid.young; }

// Of a body at the place where it is struck.
struct Struck {
  Solid solid;
  double inverse_mass = 0;  // of what moves, 1/kg; 0: it stands
  double curvature = 0;     // 1/m; 0: flat
  double radius = 0;        // of a ball of its volume, m
  double length = 0;        // sum of its three sizes, m
};

constexpr double kRestitution = 0.5;  // of small hard things; measured ones lie between 0.3 and 0.8

struct Strike {
  double duration = 0;  // of the touch, s (Hertz)
  double mass = 0;      // of both together, kg; 0: neither moves
  double speed = 0;     // of approach, m/s
};
// Null mass where neither can move.
Strike strike(const Struck& a, const Struck& b, double speed);

// The sound of a ball that is accelerated by a half sine of force, at 1 m: p(t) in Pa. A dipole's exact solution
// (Chadwick, Zheng and James, ACM Trans Graph 2012;31:59): two poles, one zero.
struct Click {
  double duration = 0;  // of the half sine, s
  double scale = 0;     // density x radius^3 x cosine x peak acceleration
  double settling = 1;  // radius over the speed of sound, s

  // It is over then, s.
  double end() const { return duration + 14 * settling; }
  // About the largest it gets, Pa; within 3 dB where the touch is long, too large where it is short.
  double peak() const;
};
// Its course.
class ClickWave {
 public:
  explicit ClickWave(const Click& click);
  // From the first touch on; 0 before, and once it is over.
  double at(double time) const;

 private:
  double answer(double time) const;

  Click click_;
  double turn_;  // rad/s
  std::array<double, 2> lasting_, dying_;
};

// Of a body of this radius; `cosine` of the angle between blow and listener.
Click click(const Strike& strike, double inverse_mass, double radius, double cosine);

// Over all directions of a dipole, the root of the mean square of the cosine.
constexpr double kMeanCosine = 0.5773502691896258;

// What rings after a blow.

// Modes that sound together, each as a decaying sine that starts with the blow.
struct Ringing {
  std::size_t count = 0;
  std::array<Mode, kModes> modes{};  // gains in Pa at 1 m
};

// Of things whose three sizes sum to so many metres. The limits between sizes are an estimate.
const ModeSet& mode_set(int timbre, double length);

// None where the body does not ring.
Ringing ringing(const Strike& strike, const Struck& body);

}  // namespace mimo::sound
