// An immutable compiled model, shared by all worlds made from it.
#pragma once

#include <mujoco/mjmodel.h>

#include <memory>
#include <string>
#include <vector>

#include "base/log.h"
#include "base/span.h"
#include "mimo/access.h"

namespace mimo::engine {

using ModelPtr = std::shared_ptr<const mjModel>;

// A file that the document refers to by name and that is given in memory.
struct Asset {
  std::string name;
  Span<const unsigned char> bytes;
};

// Compiles MJCF text. Files not among the assets are read from disk; relative paths start from the working
// directory. Throws Status::kModel with MuJoCo's message. Warnings of the compiler go to the log.
ModelPtr compile(const std::string& xml, const std::vector<Asset>& assets, const LogSink& log);

// Of a model that was compiled without contacts, before anybody else has it.
void enable_contacts(const mjModel& model);

// The version of MuJoCo that this was compiled for, as "2.2.2".
std::string compiled_version();

// Kinds of model elements, of the header.
enum class Kind : mimo_kind {
  kBody = MIMO_BODY,
  kJoint = MIMO_JOINT,
  kGeom = MIMO_GEOM,
  kSite = MIMO_SITE,
  kCamera = MIMO_CAMERA,
  kActuator = MIMO_ACTUATOR,
  kSensor = MIMO_SENSOR,
  kLight = MIMO_LIGHT,
};

mjtObj object_type(Kind kind);
int count(const mjModel& model, Kind kind);
const char* name(const mjModel& model, Kind kind, int id);    // "" where the model gives none
int find(const mjModel& model, Kind kind, const char* name);  // -1 when there is none
// Like find, but throws Status::kNotFound with some of the names that are there.
int find_or_fail(const mjModel& model, Kind kind, const std::string& name);
const char* word(Kind kind);  // "joint"

}  // namespace mimo::engine
