// What went wrong in physics steps that went on all the same, or that ended the world, counted by kind.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>
#include <string>

namespace mimo::engine {

// As mimo.h numbers them (MIMO_WARNING_...).
enum class Warning : int {
  kOther,
  kContactsDropped,
  kConstraintsDropped,
  kBadPosition,
  kBadVelocity,
  kBadAcceleration,
  kBadControl,
  kInertia,
  kNotConverged,
};
constexpr int kWarnings = 9;

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
