// Kinds of what named access reaches: elements of the model, and what only a world has.
#pragma once

#include <string>

#include "env/world.h"
#include "mimo/experimental.h"

namespace mimo::access {

// Of the header. The first eight are engine::Kind.
enum class Kind : mimo_kind {
  kBody = MIMO_BODY,
  kJoint = MIMO_JOINT,
  kGeom = MIMO_GEOM,
  kSite = MIMO_SITE,
  kCamera = MIMO_CAMERA,
  kActuator = MIMO_ACTUATOR,
  kSensor = MIMO_SENSOR,
  kLight = MIMO_LIGHT,
  kContact = MIMO_CONTACT,
  kStepContact = MIMO_STEP_CONTACT,
  kAgent = MIMO_AGENT,
  kFace = MIMO_FACE,
  kWorld = MIMO_WORLD,
  kWarning = MIMO_WARNING,
};
constexpr int kKinds = MIMO_WARNING;

const char* word(Kind kind);      // "joint"
std::string constant(Kind kind);  // "MIMO_JOINT"
// The constant of the header that some words name: "MIMO_JOINT_POSITION" of "joint position".
std::string constant(const std::string& words);

// All throw Status::kUnsupported for contacts of whole steps in a world that does not record them.
int count(const env::World& world, Kind kind);
// Throws Status::kNotFound with some of the names that are there.
int find_or_fail(const env::World& world, Kind kind, const std::string& name);
// The same where there may be no world, but only a model: throws Status::kUnsupported for what only worlds have. The
// name "" is that of an agent without one.
int find_or_fail(const mjModel& model, const env::World* world, Kind kind, const std::string& name);
const char* name(const env::World& world, Kind kind, int id);  // "" for what has none

// The body that an element belongs to; of a body its parent. Throws Status::kInvalidArgument for other kinds.
int body_of(const env::World& world, Kind kind, int id);

}  // namespace mimo::access
