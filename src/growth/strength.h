// How strong an infant is. Nobody has measured voluntary torques before three years: all of it is estimated, from how
// muscles grow and from what infants of an age can do.
#pragma once

#include "growth/growth.h"
#include "growth/skeleton.h"

namespace mimo::growth {

// Sets gears and muscles' peak forces of a body that has its sizes and masses.
void strengthen(Skeleton& body, const Skeleton& base, const Growth& growth);

// Torque of the neck over the moment of the head's weight about it, at an age.
double neck_ratio(double age);

}  // namespace mimo::growth
