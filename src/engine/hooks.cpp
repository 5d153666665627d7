#include "engine/hooks.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <mutex>
#include <thread>

#include "base/fail.h"
#include "base/process.h"
#include "compat/mujoco.h"

namespace mimo::engine {
namespace {

constexpr std::chrono::seconds kPatience(10);  // of fork()
constexpr std::chrono::milliseconds kNap(1);

std::mutex mutex;
std::atomic<int> forks{0};       // that are waiting or under way
std::atomic<bool> stuck{false};  // MuJoCo's lock was closed when this process was forked
// Of this thread. It is the only one that lives on in a child.
thread_local bool compiling = false;
thread_local bool locked_for_fork = false;

void before_fork() {
  ++forks;
  const auto end = std::chrono::steady_clock::now() + kPatience;
  const auto worth_waiting = [end] { return !compiling && std::chrono::steady_clock::now() < end; };
  while (!(locked_for_fork = mutex.try_lock()) && worth_waiting()) std::this_thread::sleep_for(kNap);
}

void after_fork_in_parent() {
  if (locked_for_fork) mutex.unlock();
  locked_for_fork = false;
  --forks;
}

void after_fork_in_child() {
  if (!locked_for_fork) stuck = true;
  after_fork_in_parent();
  forks = 0;
}

[[maybe_unused]] const int watching = watch_forks(before_fork, after_fork_in_parent, after_fork_in_child);

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

void add(Warning kind, WarningCounts& counts) { ++counts[static_cast<std::size_t>(kind)]; }

}  // namespace

CompileLock::CompileLock() {
  if (stuck) {
    fail(Status::kForked,
         "this process was forked while another thread compiled a model, so MuJoCo's compiler stays locked in "
         "it; fork at another time, or spawn a process instead");
  }
  while (forks > 0) std::this_thread::sleep_for(kNap);  // they have waited longer
  mutex.lock();
  compiling = true;
}

CompileLock::~CompileLock() {
  compiling = false;
  mutex.unlock();
}

void refuse_callbacks(const mjModel* model) {
  const char* name = disturber(model);
  if (name == nullptr) return;
  const bool table = std::strcmp(name, "mjCOLLISIONFUNC") == 0;
  fail(Status::kUnsupported,
       "the program has {} MuJoCo's global {}, which also acts on libmimo's worlds: {} before each call of libmimo",
       table ? "changed" : "set", name, table ? "restore it" : "set it to NULL");
}

const char* word(Warning kind) {
  switch (kind) {
    case Warning::kContactsDropped: return "contacts dropped";
    case Warning::kConstraintsDropped: return "constraints dropped";
    case Warning::kBadPosition: return "bad position";
    case Warning::kBadVelocity: return "bad velocity";
    case Warning::kBadAcceleration: return "bad acceleration";
    case Warning::kBadControl: return "bad control";
    case Warning::kInertia: return "inertia";
    case Warning::kNotConverged: return "not converged";
    case Warning::kOther: break;
  }
  return "other";
}

Warning kind_of(mjtWarning warning) {
  switch (warning) {
    case mjWARN_INERTIA: return Warning::kInertia;
    case mjWARN_CONTACTFULL: return Warning::kContactsDropped;
    case mjWARN_CNSTRFULL: return Warning::kConstraintsDropped;
    case mjWARN_BADQPOS: return Warning::kBadPosition;
    case mjWARN_BADQVEL: return Warning::kBadVelocity;
    case mjWARN_BADQACC: return Warning::kBadAcceleration;
    case mjWARN_BADCTRL: return Warning::kBadControl;
    default: return Warning::kOther;
  }
}

WarningWatch::WarningWatch(const mjData& data) : before_{} {
  for (int i = 0; i < mjNWARNING; ++i) before_[i] = data.warning[i].number;
}

// MuJoCo forgets what it noted when it resets a world that has diverged.
void WarningWatch::count(const mjModel& model, const mjData& data, WarningCounts& counts) const {
  for (int i = 0; i < mjNWARNING; ++i) {
    const int now = data.warning[i].number;
    if (now != 0 && now != before_[i]) add(kind_of(static_cast<mjtWarning>(i)), counts);
  }
  if (data.nefc > 0 && compat::iterations(data) >= model.opt.iterations) add(Warning::kNotConverged, counts);
}

}  // namespace mimo::engine
