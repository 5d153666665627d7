// The muscles of a joint that a motor turns: how hard they pull, and over which angles.
#pragma once

#include <utility>

typedef struct mjModel_ mjModel;

namespace mimo::body {

struct Body;
struct Joint;

// The range of a motor's force, before its gear; what has none pulls as hard as its controls may tell it, 0 and 0 where
// they may be anything.
std::pair<double, double> forces_of(const mjModel& model, int motor);

// The angles between which the muscles of one of its joints go from their shortest to their longest: the joint's range.
// A joint that goes less far, or further, at the body's age than at 18 months keeps the width of 18 months, around its
// middle: what holds a young joint back does not move the muscles' ends, which are their levers, and muscles fit the
// angles at which they work. Throws Status::kModel for numbers in the document that do not fit the body.
std::pair<double, double> muscle_range(const mjModel& model, const Body& body, const Joint& joint);

}  // namespace mimo::body
