// Composites: ropes, loops, grids, cloth, particles and soft boxes of MJCF, which MuJoCo knew until version 3.
#pragma once

#include <pugixml.hpp>

#include "document/limits.h"
#include "document/report.h"

namespace mimo::document {

// Puts in place of each composite the bodies, joints, geoms, sites, tendons, constraints and the skin that MuJoCo 2.2
// makes of it, and reports it. Throws Status::kModel for a composite that MuJoCo 2.2 would refuse, and for documents
// with composites that do not keep within the limits.
void expand_composites(pugi::xml_node root, const Limits& limits, Report& report);

}  // namespace mimo::document
