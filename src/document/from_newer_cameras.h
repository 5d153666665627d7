// Cameras as newer versions of MuJoCo describe them: by a lens and a sensor.
#pragma once

#include <pugixml.hpp>

#include "document/report.h"

namespace mimo::document {

// Turns focal lengths and sensors into fields of view, and tells what a field of view cannot say.
void translate_cameras(pugi::xml_node root, Report& report);

}  // namespace mimo::document
