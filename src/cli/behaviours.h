// mimo info --tasks: what scenes measure of their infants.
#pragma once

#include <mimo/mimo.hpp>
#include <optional>
#include <string>

#include "programs/world.h"

namespace cli {

inline constexpr char kBehaviour[] = "behaviour";  // the task that documents describe

// Nothing for a scene whose document describes none.
std::optional<mimo_behaviour> behaviour_of(mimo::Scene& scene);

// Of all built-in scenes, and the tasks that are not described by a document; of one scene, a name or a file, where it
// is given.
void print_behaviours(const WorldOptions& options, bool one_scene, bool json);

}  // namespace cli
