// An immutable compiled model, shared by all worlds made from it: its joints, its <custom> section, and its
// fingerprint.
#pragma once

#include <mujoco/mjmodel.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/log.h"
#include "base/span.h"
#include "mimo/access.h"

namespace mimo::engine {

// An immutable compiled model, shared by all worlds made from it.

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

// What a document says in its <custom> section: plain MJCF with settings for programs that know the names.

// "" if there is none of that name.
std::string custom_text(const mjModel& model, const std::string& name);

// Names of all lists of numbers, and of all tuples; "" for those without one.
std::vector<std::string> custom_number_names(const mjModel& model);
std::vector<std::string> custom_tuple_names(const mjModel& model);

// Empty if there is none of that name.
Span<const double> custom_numbers(const mjModel& model, const std::string& name);

struct TupleEntry {
  int id;
  double value;
};

// Entries of a tuple that are of one kind; empty if there is none of that name.
std::vector<TupleEntry> custom_tuple(const mjModel& model, const std::string& name, Kind kind);

// What kinds of joints there are in a compiled model.

// A hinge or a slide, whose position is one number.
bool has_one_axis(const mjModel& model, int joint);

// How many numbers a joint of this type (mjJNT_...) has for its position, and for its velocity.
int position_count(int joint_type);
int velocity_count(int joint_type);

// Where the quaternion starts among the numbers of its position; -1 if it has none.
int quaternion_place(int joint_type);

// Where the position of a body with a free joint starts in qpos. Throws Status::kModel for a body without.
int free_joint_address(const mjModel& model, int body);

// Makes a quaternion one of length 1, as MuJoCo does.
void normalize_quaternion(double* quaternion);

// Tells compiled models apart.

// A hash of everything that a model is simulated by: sizes, names, numbers. It is taken from the compiled model and
// not from its XML, because that is where meshes and files included from disk have ended up. Numbers count to single
// precision: models that another machine's maths library compiled differently in the last digit are the same model.
// Textures do not count: they change pictures only, and they are 99 of 100 bytes.
std::uint64_t fingerprint(const mjModel& model);

// A hash of its sizes and names: the same for models whose numbers differ.
std::uint64_t shape(const mjModel& model);

}  // namespace mimo::engine
