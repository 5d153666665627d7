// The sense of hearing: the sound at both ears, and what of it is heard.
#pragma once

#include <memory>

#include "body/body.h"
#include "hearing/bands.h"
#include "observation/sense.h"
#include "senses/hearing/soundscape.h"

namespace mimo::senses {

struct HearingOptions {
  bool ears = false;   // hearing/ear_left, hearing/ear_right
  bool bands = false;  // hearing/bands, hearing/time_difference

  bool any() const { return ears || bands; }
};

struct HearingSetting {
  const Soundscape* around = nullptr;  // outlives the sense, and goes on before it
  std::size_t ticks = 1;               // of a step, whose sound is told
  hearing::Levels thresholds{};        // dB of 20 uPa
};

// Throws Status::kUnsupported for an agent without a head that is a ball.
std::unique_ptr<observation::Sense> make_hearing(const mjModel& model, const body::Body& body,
                                                 const HearingOptions& options, const HearingSetting& setting);

}  // namespace mimo::senses
