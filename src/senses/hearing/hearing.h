// The sense of hearing: the sound at both ears, and what of it is heard.
#pragma once

#include <memory>

#include "body/body.h"
#include "hearing/bands.h"
#include "hearing/ears.h"
#include "observation/sense.h"
#include "senses/hearing/options.h"
#include "senses/hearing/soundscape.h"

namespace mimo::senses {

struct HearingSetting {
  const Soundscape* around = nullptr;      // outlives the sense, and goes on before it
  std::size_t ticks = 1;                   // of a step, whose sound is told
  hearing::Levels thresholds{};            // dB of 20 uPa
  std::size_t own = hearing::Ears::kNone;  // of the sources around, its own voice
};

// Ears are on an infant's head, and on the first body of what is no infant: on its largest ball, or, where it has none,
// as on an adult's head around its centre of mass. Throws Status::kUnsupported for the world.
std::unique_ptr<observation::Sense> make_hearing(const mjModel& model, const body::Body& body,
                                                 const HearingOptions& options, const HearingSetting& setting);

// Where an infant's mouth is and in which direction it speaks; throws Status::kUnsupported for a body without a mouth.
Mouth mouth_of(const mjModel& model, const body::Body& body);

}  // namespace mimo::senses
