// Documents that were written for MuJoCo 2, where a newer version runs.
#pragma once

#include <pugixml.hpp>

#include "document/limits.h"
#include "document/report.h"

namespace mimo::document {

// Puts what newer versions of MuJoCo no longer know into words that they have, with the same meaning where that can
// be, and reports it. Throws Status::kModel for what is gone and had a part in how things move.
void upgrade_older(pugi::xml_node root, const Limits& limits, Report& report);

}  // namespace mimo::document
