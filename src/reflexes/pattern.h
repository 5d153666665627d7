// Which motors a reflex pulls, and when.
#pragma once

#include <string>

#include "base/span.h"
#include "reflexes/table.h"

namespace mimo::reflexes {

enum class Limb { kOwn, kOther, kMiddle };  // of the side of the reflex, of the other side, of neither
enum class Phase { kAlways, kFirst, kSecond, kCrossed };

// A motor that is pulled to its positive or its negative side.
struct Pull {
  Limb limb;
  const char* motor;  // without "act:" and without the side
  double share;       // of the reflex's amplitude; of a motor in the middle, for the reflex of the left side
  Phase phase = Phase::kAlways;
  bool needed = true;  // without it the body cannot do the reflex
};

Span<const Pull> pattern(Reflex reflex);
// The name of its motor, for a reflex of that side.
std::string motor_name(const Pull& pull, Side side);
// The share, for a reflex of that side that has acted for so long, at an age in months.
double share(const Pull& pull, Side side, double seconds, double months);

// Legs that step take turns: how far the one that leads, or the other one, is lifted so long after they began, 0 to 1.
double swing(double seconds, bool leads);

}  // namespace mimo::reflexes
