// How far to go along a direction: the least of the solver's cost on a line.
#pragma once

#include <mujoco/mjdata.h>

namespace mimo::solver {

// The cost along a line is convex: of second order for every row in a state that lasts, and cones.
struct Line {
  const double* start;      // J qacc - aref of each row
  const double* direction;  // and how it changes along the line
  double slope, curvature;  // of the part without constraints, at the start
};

// Where the slope is within the tolerance of zero, or as near as numbers allow; 0 if the cost does not fall along the
// line.
double find_least(mjData& data, const Line& line, double tolerance);

}  // namespace mimo::solver
