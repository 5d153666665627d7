#include "engine/muscle.h"

#include <mujoco/mujoco.h>

#include <array>

namespace mimo::engine {
namespace {

using Parameters = std::array<mjtNum, 9>;

// In the order of MuJoCo's gainprm: range, force, scale, lmin, lmax, vmax, fpmax, fvmax. The scale is for a force that
// is not given.
Parameters parameters(const MuscleShape& shape) {
  return {shape.short_end, shape.long_end, shape.peak_force, 0, shape.shortest, shape.longest,
          shape.fastest,   shape.passive,  shape.stretched};
}

}  // namespace

double muscle_active_force(const MuscleShape& shape, double length, double velocity) {
  const Parameters prm = parameters(shape);
  const std::array<mjtNum, 2> range = {shape.short_end, shape.long_end};
  return -mju_muscleGain(length, velocity, range.data(), 1, prm.data());
}

double muscle_passive_force(const MuscleShape& shape, double length) {
  const Parameters prm = parameters(shape);
  const std::array<mjtNum, 2> range = {shape.short_end, shape.long_end};
  return -mju_muscleBias(length, range.data(), 1, prm.data());
}

double muscle_activation_rate(double control, double activation, double rise, double fall) {
  const std::array<mjtNum, 3> prm = {rise, fall, 0};  // newer versions have a third: how smoothly one becomes the other
  return mju_muscleDynamics(control, activation, prm.data());
}

}  // namespace mimo::engine
