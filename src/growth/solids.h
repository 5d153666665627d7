// Volume and inertia of a geom.
#pragma once

#include <Eigen/Core>

#include "growth/skeleton.h"

namespace mimo::growth {

double volume(const Geom& geom);  // m^3

// About its centre, around its own axes, kg m^2.
Eigen::Vector3d inertia(const Geom& geom);

// Half of its extent along a direction of length 1 in the geom's frame, m.
double half_extent(const Geom& geom, const Eigen::Vector3d& direction);

// Which of the bone's axes (0 x, 1 y, 2 z) each of the geom's own points along, or nearly so.
std::array<int, 3> bone_axes(const Geom& geom);

}  // namespace mimo::growth
