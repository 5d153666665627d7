// The part that runs once for each vector of rays, compiled for several instruction sets.
#pragma once

#include <vector>

#include "rays/grid.h"

namespace mimo::rays {

using DrawTile = void (*)(const Grid& grid, int tile);

struct Path {
  const char* name;
  DrawTile draw;
};

// What this build has for this machine, best first; never empty.
std::vector<Path> paths();

}  // namespace mimo::rays
