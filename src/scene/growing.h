// Gives an infant of a document another age.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "growth/growth.h"

namespace mimo::scene {

// Its body, and what follows from that: it starts in the same pose, as far as its joints go, and with its lowest point
// where that was; the document says how it has grown. At 18 months nothing changes. Throws Status::kNotFound for an
// infant that is not there, and what growth::grown throws; then the document is half changed.
void grow(pugi::xml_node root, const std::string& prefix, const growth::Growth& growth);

}  // namespace mimo::scene
