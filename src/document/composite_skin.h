// Skins of composites.
#pragma once

#include <pugixml.hpp>

#include "document/composite.h"

namespace mimo::document {

// Both do nothing for a composite without a skin: over a grid or cloth, and over a box, cylinder or ellipsoid.
void add_sheet_skin(const Composite& composite, pugi::xml_node assets);
void add_solid_skin(const Composite& composite, pugi::xml_node assets);

}  // namespace mimo::document
