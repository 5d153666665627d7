// What rings after a blow.
#pragma once

#include "sound/mode_tables.h"
#include "sound/strike.h"

namespace mimo::sound {

// Modes that sound together, each as a decaying sine that starts with the blow.
struct Ringing {
  std::size_t count = 0;
  std::array<Mode, kModes> modes{};  // gains in Pa at 1 m
};

// Of things whose three sizes sum to so many metres. The limits between sizes are an estimate.
const ModeSet& mode_set(int timbre, double length);

// None where the body does not ring.
Ringing ringing(const Strike& strike, const Struck& body);

}  // namespace mimo::sound
