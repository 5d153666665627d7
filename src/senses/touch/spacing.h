// How far apart touch sensors are on each part of the body.
#pragma once

#include <string_view>

namespace mimo::senses::touch {

// Distance in metres by a body's name without its agent's prefix; 0, no skin, for bodies that are not the infant's own.
double default_spacing(std::string_view body);

}  // namespace mimo::senses::touch
