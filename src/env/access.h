// Named access: reading and writing quantities of many model elements at once.
#pragma once

#include <array>
#include <cstdint>

#include "base/span.h"
#include "engine/physics.h"

namespace mimo::env {

// As mimo.h numbers them (MIMO_JOINT_POSITION ...).
enum class Quantity : int {
  kJointPosition = 1,
  kJointVelocity,
  kJointForce,
  kJointAcceleration,
  kJointRange,
  kBodyPosition,
  kBodyOrientation,
  kBodyVelocity,
  kBodyForce,
  kBodyMass,
  kBodyCenterOfMass,
  kGeomPosition,
  kGeomOrientation,
  kGeomSize,
  kSitePosition,
  kSiteOrientation,
  kCameraPosition,
  kCameraOrientation,
  kActuatorControl,
  kActuatorForce,
  kSensorValue,
  kActuatorGear,
};

// Both throw Status::kInvalidArgument for a number that is none.
engine::Kind kind_from(int number);
Quantity quantity_from(int number);

// The body that an element belongs to; of a body its parent. Throws Status::kInvalidArgument for other kinds.
int body_of(const mjModel& model, engine::Kind kind, int id);

// How many values a quantity has for all ids together. Throws for ids out of range.
std::size_t width(const mjModel& model, Quantity quantity, Span<const std::int32_t> ids);

// `values` has exactly the width.
void get(const engine::Physics& physics, Quantity quantity, Span<const std::int32_t> ids, Span<double> values);
// Throws Status::kInvalidArgument for a quantity that can only be read.
void require_writable(Quantity quantity);
// Throws Status::kInvalidArgument for what set() would refuse.
void check_settable(const mjModel& model, Quantity quantity, Span<const std::int32_t> ids, Span<const double> values);
// Checks everything before it writes anything; recomputes poses when something moved.
void set(engine::Physics& physics, Quantity quantity, Span<const std::int32_t> ids, Span<const double> values);

// What a contact tells, in the order of mimo.h (MIMO_CONTACT_IDS, MIMO_CONTACT_VALUES).
struct Contact {
  std::array<std::int32_t, 4> ids;  // geom 1, geom 2, body of geom 1, body of geom 2
  std::array<double, 19> values;    // position 3, frame 9, distance 1, force on body 2 in that frame 3, torque 3
};
Contact contact(const mjModel& model, const mjData& data, int index);

}  // namespace mimo::env
