// Gives an infant of a document, and what stands around it, another age.
#pragma once

#include <array>
#include <functional>
#include <pugixml.hpp>
#include <string>

#include "growth/growth.h"

namespace mimo::scene {

// What stands around an infant and goes with its size, as a recipe says. Factors are those against 18 months.

// Bodies that are built to its stature, and where it holds on to the world: all is so many times as far from the
// origin. Its root moves over the ground alike.
void fit_to_stature(pugi::xml_node root, const std::string& prefix, double stature);

// Where an infant's body is at the start, by its name without the prefix; before and after it has grown.
struct Reference {
  using Place = std::function<std::array<double, 3>(const std::string&)>;
  Place was, is;
};

// Bodies that are within reach: so many times as far from a part of it.
void fit_to_arm(pugi::xml_node root, const std::string& prefix, double arm, const Reference& reference);

// Gives an infant of a document another age.

// Its body, and what follows from that: it starts in the same pose, as far as its joints go, and with its lowest point
// where that was; the document says how it has grown. At 18 months nothing changes. Throws Status::kNotFound for an
// infant that is not there, and what growth::grown throws; then the document is half changed.
void grow(pugi::xml_node root, const std::string& prefix, const growth::Growth& growth);

}  // namespace mimo::scene
