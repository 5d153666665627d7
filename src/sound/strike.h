// Two bodies meet: how long they touch, and what that gives to the air.
#pragma once

#include <array>

#include "sound/solid.h"

namespace mimo::sound {

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

}  // namespace mimo::sound
