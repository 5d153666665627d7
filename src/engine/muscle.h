// MuJoCo's own muscle model, as functions.
#pragma once

namespace mimo::engine {

struct MuscleShape {
  double short_end, long_end;  // normalised lengths at the ends of the range, which are their own scale
  double peak_force;
  double shortest, longest;  // lengths beyond which activation gives no force
  double fastest;            // shortening velocity, lengths a second
  double passive;            // passive force at the longest length, in peak forces
  double stretched;          // factor of the active force of a muscle that is stretched fast
};

// Active force at full activation and passive force; positive where the muscle pulls.
double muscle_active_force(const MuscleShape& shape, double length, double velocity);
double muscle_passive_force(const MuscleShape& shape, double length);

// Rate of the activation, 1/s, for a control signal from 0 to 1: it rises with one time constant (s) and falls with the
// other, both stretched or shortened by the activation itself.
double muscle_activation_rate(double control, double activation, double rise, double fall);

}  // namespace mimo::engine
