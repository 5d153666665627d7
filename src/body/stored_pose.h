// The pose that a document stores, in which its model starts.
#pragma once

#include "base/span.h"
#include "engine/model.h"

namespace mimo::body {

// Writes it into qpos: the numbers "mimo:root" for the root of an infant (body mimo_location), tuples "mimo:pose" for
// hinges and slides. Each may have the prefix of an infant or object, "anna/mimo:pose". What is not stored stays as it
// is. Throws Status::kModel for a root without a free joint and for other joints.
void read_stored_pose(const mjModel& model, Span<double> qpos);

}  // namespace mimo::body
