// What went wrong in physics steps that went on all the same, or that ended the world, counted by kind.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <string>

#include "mimo/experimental/engine.h"

namespace mimo::engine {

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
