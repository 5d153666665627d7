// How far it is from each part of an infant to its brain stem, along the limbs.
#pragma once

#include <vector>

#include "body/body.h"

namespace mimo::body {

// Metres by body of the model, 0 for those that are no part of it and where the agent has no head: from the middle of
// the part through the joints on its way to the base of the neck, and on to the middle of the head, times a factor for
// each of arm, leg, spine and head. It depends on no pose.
std::vector<double> nerve_lengths(const mjModel& model, const Body& body);
// The same for one body, of whatever infant it is a part.
double nerve_length(const mjModel& model, int body);

}  // namespace mimo::body
