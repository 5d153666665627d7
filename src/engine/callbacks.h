// MuJoCo has callbacks that belong to the process: one that the host sets for its own simulation acts on our worlds
// too.
#pragma once

#include <mujoco/mjmodel.h>

namespace mimo::engine {

// Throws Status::kUnsupported, naming the callback, when one is set that would act on worlds of this model; null: on
// those of a model that is about to be compiled.
void refuse_callbacks(const mjModel* model);

}  // namespace mimo::engine
