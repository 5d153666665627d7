// Angles are radians; people say degrees.
#pragma once

namespace cli {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

}  // namespace cli
