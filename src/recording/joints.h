// The joints of a world, as recordings name and number them.
#pragma once

#include <string>
#include <vector>

#include "access/access.h"

namespace mimo::recording {

std::string joint_names(const env::World& world);  // a line each
// A line for each column: a free joint has seven positions and six velocities.
std::string joint_columns(const env::World& world, mimo_quantity quantity);
// Of all joints.
void read_joints(const env::World& world, mimo_quantity quantity, std::vector<double>& values);

}  // namespace mimo::recording
