// Which part of the body holds the muscles of a motor.
#pragma once

#include <string>

#include "growth/skeleton.h"

namespace mimo::growth {

// Name of a geom, whose volume stands for that of the muscles. Throws Status::kUnsupported for a motor that is none of
// ours.
std::string muscle_geom(const Skeleton& skeleton, const Motor& motor);

bool moves_neck(const Motor& motor);
bool moves_eye(const Motor& motor);

}  // namespace mimo::growth
