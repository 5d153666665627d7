// What stands around an infant and goes with its size, as a recipe says. Factors are those against 18 months.
#pragma once

#include <array>
#include <functional>
#include <pugixml.hpp>
#include <string>

namespace mimo::scene {

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

}  // namespace mimo::scene
