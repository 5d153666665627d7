#include "body/motor_forces.h"

#include <mujoco/mjmodel.h>

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/names.h"
#include "body/body.h"
#include "engine/custom.h"

namespace mimo::body {
namespace {

// Which of the body's hinges a joint is, and how many there are.
struct Place {
  std::size_t number, of;
};

Place place_of(const mjModel& model, const Body& body, int joint) {
  Place place{0, 0};
  for (int id = 0; id < model.njnt; ++id) {
    if (model.jnt_type[id] != mjJNT_HINGE || !body.has(model.jnt_bodyid[id])) continue;
    if (id < joint) ++place.number;
    ++place.of;
  }
  return place;
}

}  // namespace

std::pair<double, double> forces_of(const mjModel& model, int motor) {
  if (model.actuator_forcelimited[motor] != 0) {
    return {model.actuator_forcerange[2 * motor], model.actuator_forcerange[2 * motor + 1]};
  }
  const double gain = model.actuator_gaintype[motor] == mjGAIN_FIXED ? model.actuator_gainprm[mjNGAIN * motor] : 0;
  const double* controls = model.actuator_ctrlrange + 2 * motor;
  if (model.actuator_ctrllimited[motor] == 0) return {0, 0};
  return {std::min(gain * controls[0], gain * controls[1]), std::max(gain * controls[0], gain * controls[1])};
}

std::pair<double, double> muscle_range(const mjModel& model, const Body& body, const Joint& joint) {
  const std::string name = body.prefix + names::kBornRanges;
  const Span<const double> numbers = engine::custom_numbers(model, name);
  if (numbers.empty() || model.jnt_type[joint.id] != mjJNT_HINGE) return {joint.low, joint.high};
  const Place place = place_of(model, body, joint.id);
  if (numbers.size() != 2 * place.of) {
    fail(Status::kModel, "numeric {} has {} numbers, expected two for each of the infant's {} hinges", name,
         numbers.size(), place.of);
  }
  const double low = numbers[2 * place.number], high = numbers[2 * place.number + 1];
  if (!(low < high && std::isfinite(low) && std::isfinite(high))) {
    fail(Status::kModel, "numeric {}: joint \"{}\" goes from {} to {}, expected a range", name,
         engine::name(model, engine::Kind::kJoint, joint.id), low, high);
  }
  const double wider = 0.5 * ((high - low) - (joint.high - joint.low));
  constexpr double kSame = 1e-9;  // rad; what a document is rounded to
  if (!(std::abs(wider) > kSame) || !std::isfinite(wider)) return {joint.low, joint.high};
  return {joint.low - wider, joint.high + wider};
}

}  // namespace mimo::body
