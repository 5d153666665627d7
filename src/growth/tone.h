// How stiff and how sluggish the joints are that nobody moves.
#pragma once

#include "growth/growth.h"
#include "growth/skeleton.h"

namespace mimo::growth {

// Sets stiffness, damping, dry friction and armature of a body that has its sizes and masses. Stiffness and friction go
// with the moment of the weight that a joint carries, so that what hangs at rest hangs alike; stiffness also with the
// flexor tone of newborns, who curl up. Damping and armature keep the motion alike.
void set_tone(Skeleton& body, const Skeleton& base, const Growth& growth);

}  // namespace mimo::growth
