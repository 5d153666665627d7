// Kinds of what named access reaches: elements of the model, and what only a world has.
#pragma once

#include <string>

#include "env/world.h"

namespace mimo::env {

// As mimo.h numbers them (MIMO_BODY ...). The first eight are engine::Kind.
enum class Kind : int {
  kBody = 1,
  kJoint,
  kGeom,
  kSite,
  kCamera,
  kActuator,
  kSensor,
  kLight,
  kContact,
  kStepContact,
  kAgent,
  kFace,
  kWorld,
  kWarning,
};
constexpr int kKinds = 14;

const char* word(Kind kind);  // "joint"

// All throw Status::kUnsupported for contacts of whole steps in a world that does not record them.
int count(const World& world, Kind kind);
// Throws Status::kNotFound with some of the names that are there.
int find_or_fail(const World& world, Kind kind, const std::string& name);
// The same where there may be no world, but only a model: throws Status::kUnsupported for what only worlds have. The
// name "" is that of an agent without one.
int find_or_fail(const mjModel& model, const World* world, Kind kind, const std::string& name);
const char* name(const World& world, Kind kind, int id);  // "" for what has none

// The body that an element belongs to; of a body its parent. Throws Status::kInvalidArgument for other kinds.
int body_of(const World& world, Kind kind, int id);

}  // namespace mimo::env
