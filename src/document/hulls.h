// Convex hulls, as far as one can tell of them before MuJoCo makes them.
#pragma once

#include <array>
#include <pugixml.hpp>
#include <vector>

#include "document/limits.h"

namespace mimo::document {

// How many corners the convex hull of points has, at most: of many points, as many in proportion as that of some of
// them, for what is a corner among all is one among fewer. The points must not be flat.
double hull_corners(std::vector<std::array<double, 3>> points);

// The vertices that MuJoCo keeps of a mesh's file with faces of many corners: it leaves out what it cannot cut into
// triangles. Throws Status::kModel where it cannot read the file.
std::vector<std::array<double, 3>> kept_vertices(pugi::xml_node mesh, const Limits& limits);

}  // namespace mimo::document
