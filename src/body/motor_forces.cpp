#include "body/motor_forces.h"

#include <mujoco/mjmodel.h>

#include <algorithm>

namespace mimo::body {

std::pair<double, double> forces_of(const mjModel& model, int motor) {
  if (model.actuator_forcelimited[motor] != 0) {
    return {model.actuator_forcerange[2 * motor], model.actuator_forcerange[2 * motor + 1]};
  }
  const double gain = model.actuator_gaintype[motor] == mjGAIN_FIXED ? model.actuator_gainprm[mjNGAIN * motor] : 0;
  const double* controls = model.actuator_ctrlrange + 2 * motor;
  if (model.actuator_ctrllimited[motor] == 0) return {0, 0};
  return {std::min(gain * controls[0], gain * controls[1]), std::max(gain * controls[0], gain * controls[1])};
}

}  // namespace mimo::body
