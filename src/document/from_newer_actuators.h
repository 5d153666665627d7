// Actuators as newer versions of MuJoCo write them.
#pragma once

#include <pugixml.hpp>

namespace mimo::document {

// Says what there is a general actuator or a range for: kv and timeconst of position actuators, inheritrange, and the
// limits of the force at a joint that one motor moves. What it cannot say stays as it is.
void translate_actuators(pugi::xml_node root);

}  // namespace mimo::document
