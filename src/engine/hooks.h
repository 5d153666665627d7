// MuJoCo has one compiler lock, callbacks and warnings for the whole process; the library's worlds must not be reached
// by the host's.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <string>

#include "mimo/experimental/engine.h"

namespace mimo::engine {

// One model is compiled at a time: MuJoCo's compiler has a lock for the whole process anyway, which printing its schema
// takes as well. The library's lock makes fork() wait until no thread compiles, because a child has only the thread
// that forked, and would never see MuJoCo's lock open.

class CompileLock {
 public:
  // Throws Status::kForked in a child of a process that compiled for longer than fork() waits.
  CompileLock();
  ~CompileLock();
  CompileLock(const CompileLock&) = delete;
  CompileLock& operator=(const CompileLock&) = delete;
};

// MuJoCo has callbacks that belong to the process: one that the host sets for its own simulation acts on our worlds
// too.

// Throws Status::kUnsupported, naming the callback, when one is set that would act on worlds of this model; null: on
// those of a model that is about to be compiled.
void refuse_callbacks(const mjModel* model);

// What went wrong in physics steps that went on all the same, or that ended the world, counted by kind.

// Of the header; 0 is any other.
enum class Warning : int {
  kOther,
  kContactsDropped = MIMO_WARNING_CONTACTS_DROPPED,
  kConstraintsDropped = MIMO_WARNING_CONSTRAINTS_DROPPED,
  kBadPosition = MIMO_WARNING_BAD_POSITION,
  kBadVelocity = MIMO_WARNING_BAD_VELOCITY,
  kBadAcceleration = MIMO_WARNING_BAD_ACCELERATION,
  kBadControl = MIMO_WARNING_BAD_CONTROL,
  kInertia = MIMO_WARNING_INERTIA,
  kNotConverged = MIMO_WARNING_NOT_CONVERGED,
};
constexpr int kWarnings = MIMO_WARNING_NOT_CONVERGED + 1;

using WarningCounts = std::array<std::uint64_t, kWarnings>;

const char* word(Warning kind);  // "contacts dropped"
Warning kind_of(mjtWarning warning);

// One to tell the user of.
struct Note {
  Warning kind;
  std::string text;
};

// Adds one for each kind that a physics step has just met, and that MuJoCo had not noted before it.
class WarningWatch {
 public:
  explicit WarningWatch(const mjData& data);
  void count(const mjModel& model, const mjData& data, WarningCounts& counts) const;

 private:
  std::array<int, mjNWARNING> before_;
};

}  // namespace mimo::engine
