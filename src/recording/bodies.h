// What the infants of a world were asked to be, as a row of numbers in a recording.
#pragma once

#include <string>
#include <vector>

#include "blueprint/worlds_by_age.h"
#include "env/world.h"

namespace mimo::recording {

using blueprint::Growths;

Growths growths_of(const env::World& world);

// Numbers of one row, and what they are, a line each.
std::vector<double> row_of(const Growths& growths);
std::string names_of_row(const env::World& world);
// Throws for numbers that no infant can have been asked to be.
Growths growths_of_row(const std::vector<double>& row);

}  // namespace mimo::recording
