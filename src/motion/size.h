// The size of an infant that nobody measured, by the points that were seen of it.
#pragma once

#include <string>
#include <vector>

#include "motion/markers.h"
#include "programs/world.h"

namespace cli {

// Whether the options leave the infant's age open, in a scene that has infants of every age.
bool is_age_open(const WorldOptions& options);

struct FoundAge {
  double months;
  std::string note;  // how sure that is
};

// The age whose infant's joints come nearest to a few rows of the points, by least squares over joints and age.
FoundAge fit_age(const Markers& markers, const RetargetOptions& options, const WorldOptions& world);

}  // namespace cli
