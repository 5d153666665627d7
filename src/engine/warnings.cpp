#include "engine/warnings.h"

#include "compat/mujoco.h"

namespace mimo::engine {
namespace {

void add(Warning kind, WarningCounts& counts) { ++counts[static_cast<std::size_t>(kind)]; }

}  // namespace

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
