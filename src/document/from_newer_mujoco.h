// Documents that were written for newer versions of MuJoCo than the one that runs.
#pragma once

#include <pugixml.hpp>

#include "document/report.h"

namespace mimo::document {

// Puts what newer versions have brought into words that the MuJoCo that runs knows: with the same meaning where that
// can be; left out or by the nearest that there is, with a warning, where it does not change how things move; what else
// is unknown throws Status::kModel with its name and place.
void translate_newer(pugi::xml_node root, Report& report);

}  // namespace mimo::document
