// How strong, how far and how stiff an infant's joints are at an age.
#pragma once

#include <string>

#include "growth/growth.h"
#include "growth/skeleton.h"

namespace mimo::growth {

// How strong an infant is. No study has measured voluntary torques before three years: all of it is estimated, from how
// muscles grow and from what infants of an age can do.

// Sets gears and muscles' peak forces of a body that has its sizes and masses.
void strengthen(Skeleton& body, const Skeleton& base, const Growth& growth);

// Torque of the neck over the moment of the head's weight about it, at an age.
double neck_ratio(double age);

// How far the joints of an infant go: newborns cannot stretch hips, knees and elbows.

// Sets limits, and where the springs of hips, knees and elbows pull to, of a body that has the base's.
void limit(Skeleton& body, const Growth& growth);

// The stiffness and damping of passive joints.

// Sets stiffness, damping, dry friction and armature of a body that has its sizes and masses. Stiffness and friction go
// with the moment of the weight that a joint carries, so that what hangs at rest hangs alike; stiffness also with the
// flexor tone of newborns, who curl up. Damping and armature keep the motion alike.
void set_tone(Skeleton& body, const Skeleton& base, const Growth& growth);

// Which part of the body holds the muscles of a motor.

// Name of a geom, whose volume stands for that of the muscles. Throws Status::kUnsupported for a motor that is none of
// ours.
std::string muscle_geom(const Skeleton& skeleton, const Motor& motor);

bool moves_neck(const Motor& motor);
bool moves_eye(const Motor& motor);

}  // namespace mimo::growth
