// Tells compiled models apart.
#pragma once

#include <cstdint>

#include "engine/model.h"

namespace mimo::engine {

// A hash of everything that a model is simulated by: sizes, names, numbers. It is taken from the compiled model and
// not from its XML, because that is where meshes and files included from disk have ended up. Numbers count to single
// precision: models that another machine's maths library compiled differently in the last digit are the same model.
// Textures do not count: they change pictures only, and they are 99 of 100 bytes.
std::uint64_t fingerprint(const mjModel& model);

// A hash of its sizes and names: the same for models whose numbers differ.
std::uint64_t shape(const mjModel& model);

}  // namespace mimo::engine
