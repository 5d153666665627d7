// Pictures on surfaces, which make nearly all of a model's bytes.
#pragma once

#include "engine/model.h"

namespace mimo::engine {

// The same model; where all its textures are those of another one, it uses these, keeps that one alive for it, and
// holds none of its own.
ModelPtr with_textures_of(const ModelPtr& owner, ModelPtr model);

// Whether they are the same bytes in memory.
bool share_textures(const mjModel& one, const mjModel& other);

}  // namespace mimo::engine
