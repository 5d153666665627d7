// The original's rules, part by part of the body. Constants are sizes and places of the 18-month body, m.
#pragma once

#include <string>

#include "growth/parts.h"

namespace mimo::growth::original {

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
