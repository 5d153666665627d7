// Where an infant is put whom nobody has given a place, and what is said of one whose place is taken.
#pragma once

#include <string>

#include "base/log.h"
#include "document/pose.h"
#include "engine/physics.h"

namespace mimo::scene {

// Everything where the model starts.
engine::Physics at_start(const engine::ModelPtr& model);

// A pose in which the infant is inside of nothing: upright on what stands still below or above the origin, on the
// surface nearest to the origin's height; where something stands there already, beside it. Without such a pose, and
// where there is no ground, the origin.
document::Pose free_spot(engine::Physics& physics, const std::string& prefix);

// Where the root of an infant has to be for its anchor to lie at the place; it has the place's orientation already.
document::Pose root_of(const engine::Physics& physics, const std::string& prefix, const document::Place& place);

// A warning for an infant that starts inside of something, with how deep and in what.
void warn_of_overlap(const engine::Physics& physics, const std::string& prefix, const LogSink& log);

}  // namespace mimo::scene
