// Angles.
#pragma once

namespace mimo {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;  // in radians

}  // namespace mimo
