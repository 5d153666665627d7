// Documents that were written for other versions of MuJoCo than the one that runs.
#pragma once

#include <pugixml.hpp>

#include "document/budget.h"
#include "document/report.h"

namespace mimo::document {

// Puts what newer versions have brought into words that the MuJoCo that runs knows: with the same meaning where that
// can be; left out or by the nearest that there is, with a warning, where it does not change how things move; what else
// is unknown throws Status::kModel with its name and place.
void translate_newer(pugi::xml_node root, Report& report);

// Actuators as newer versions of MuJoCo write them.

// Says what there is a general actuator or a range for: kv and timeconst of position actuators, inheritrange, and the
// limits of the force at a joint that one motor moves. What it cannot say stays as it is.
void translate_actuators(pugi::xml_node root);

// Cameras as newer versions of MuJoCo describe them: by a lens and a sensor.

// Turns focal lengths and sensors into fields of view, and tells what a field of view cannot say.
void translate_cameras(pugi::xml_node root, Report& report);

// Documents that were written for MuJoCo 2, where a newer version runs.

// Puts what newer versions of MuJoCo no longer know into words that they have, with the same meaning where that can
// be, and reports it. Throws Status::kModel for what is gone and had a part in how things move.
void upgrade_older(pugi::xml_node root, const Limits& limits, Report& report);

}  // namespace mimo::document
