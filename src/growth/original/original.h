// The rules by which MIMo v2 makes a body of another age, for those who compare. They keep what is wrong with them:
// neither at 18 months nor in proportion do they give the body that they start from, and joints and muscles' peak
// forces stay as they are.
#pragma once

#include <string>

#include "growth/skeleton.h"

namespace mimo::growth::original {

// The measures of infants that the original's rules start from.

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

namespace mimo::growth {

// At an age from 0 to 24 months.
Skeleton grown_as_original(const Skeleton& base, double age);

}  // namespace mimo::growth

namespace mimo::growth::original {

// The original's rules, part by part of the body. Constants are sizes and places of the 18-month body, m.

struct Side {
  std::string prefix;  // of names
  double left;         // 1; -1: right
};

inline void set(Geom& geom, const Vector& size, const Vector& position) {
  geom.size = size;
  geom.position = position;
}

void grow_trunk(const Parts& parts, double age);
void grow_head(const Parts& parts, double age);
// Upper arm and forearm.
void grow_arm(const Parts& parts, const Side& side, double age);
void grow_mitten_hand(const Parts& parts, const Side& side, double age);
// Palm, fingers and thumb.
void grow_fingered_hand(const Parts& parts, const Side& side, double age);
// Thigh, shank and foot with its toes.
void grow_leg(const Parts& parts, const Side& side, double age);

}  // namespace mimo::growth::original
