#include "engine/callbacks.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "base/fail.h"

namespace mimo::engine {
namespace {

// The table of collision functions is meant to be changed, too. This is how it was when we were loaded.
struct Collisions {
  Collisions() { std::memcpy(functions.data(), mjCOLLISIONFUNC, sizeof mjCOLLISIONFUNC); }
  bool changed() const { return std::memcmp(functions.data(), mjCOLLISIONFUNC, sizeof mjCOLLISIONFUNC) != 0; }
  std::array<unsigned char, sizeof mjCOLLISIONFUNC> functions;
};
const Collisions collisions;

bool has(const int* types, int count, int type) { return std::find(types, types + count, type) != types + count; }

// mjcb_time is not among them: it is asked for the time by MuJoCo's profiler only.
const char* disturber(const mjModel* model) {
  if (mjcb_control != nullptr) return "mjcb_control";
  if (mjcb_passive != nullptr) return "mjcb_passive";
  if (mjcb_contactfilter != nullptr) return "mjcb_contactfilter";
  if (collisions.changed()) return "mjCOLLISIONFUNC";
  if (model == nullptr) return nullptr;
  // These are asked for elements of type "user" only.
  const mjModel& m = *model;
  if (mjcb_sensor != nullptr && has(m.sensor_type, m.nsensor, mjSENS_USER)) return "mjcb_sensor";
  if (mjcb_act_dyn != nullptr && has(m.actuator_dyntype, m.nu, mjDYN_USER)) return "mjcb_act_dyn";
  if (mjcb_act_gain != nullptr && has(m.actuator_gaintype, m.nu, mjGAIN_USER)) return "mjcb_act_gain";
  if (mjcb_act_bias != nullptr && has(m.actuator_biastype, m.nu, mjBIAS_USER)) return "mjcb_act_bias";
  return nullptr;
}

}  // namespace

void refuse_callbacks(const mjModel* model) {
  const char* name = disturber(model);
  if (name == nullptr) return;
  const bool table = std::strcmp(name, "mjCOLLISIONFUNC") == 0;
  fail(Status::kUnsupported,
       "the program has {} MuJoCo's global {}, which would act on libmimo's worlds, too: {} while libmimo is called",
       table ? "changed" : "set", name, table ? "restore it" : "set it to NULL");
}

}  // namespace mimo::engine
