// The part that runs once for each vector of rays, compiled for several instruction sets.
#pragma once

#include <vector>

#include "rays/grid.h"

namespace mimo::rays {

// Draws a row of tiles.
using DrawRow = void (*)(const Grid& grid, int row);

struct Path {
  const char* name;
  DrawRow draw;
};

// What this build has for this machine, best first; never empty.
std::vector<Path> paths();

}  // namespace mimo::rays
