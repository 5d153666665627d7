// The measures of infants that the original's rules start from.
#pragma once

namespace mimo::growth::original {

// Each is a logarithm of age, fitted to the means of Snyder et al. 1977 (UM-HSRI-77-17).
enum class Measure {
  kAnkle,  // circumference
  kCalf,   // circumference
  kElbowHand,
  kFootBreadth,
  kFootLength,
  kForearm,  // circumference
  kHandBreadth,
  kHandLength,
  kHead,  // circumference
  kHipBreadth,
  kKneeSole,
  kFistBreadth,
  kThigh,         // circumference
  kMiddleFinger,  // diameter
  kRumpKnee,
  kShoulderElbow,
  kThumb,     // diameter
  kUpperArm,  // circumference
};

// Half of a length or diameter, or the radius of a circumference, in m, at an age in months.
double half(Measure measure, double age);
// The same of the survey's infants of 18 months. Ankle, calf, thumb and middle finger have none.
double half_at_18(Measure measure);
// The one over the other.
double ratio(Measure measure, double age);

// How thick a hand is, over that at 18 months.
double hand_thickness(double age);

// What the original makes smaller, so that surfaces do not lie in one plane, m.
constexpr double kGap = 1e-4;

}  // namespace mimo::growth::original
