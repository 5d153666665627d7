// What sounds in a world, for whoever plays and hears there.
#pragma once

#include "env/options.h"
#include "env/perception.h"
#include "observation/observer.h"
#include "senses/hearing/soundscape.h"

namespace mimo::env {

// Null where nobody hears; else it belongs to the observer, before the senses that hear.
senses::Soundscape* add_soundscape(observation::Observer& observer, const mjModel& model, double tick,
                                   const std::vector<AgentOptions>& agents, const EnvOptions& options);

// Throws Status::kUnsupported where nobody hears, kNotFound for a body that there is not, and what Soundscape::play
// does; samples are finite numbers then.
void play(senses::Soundscape* soundscape, const mjModel& model, const std::string& body, Span<const float> samples,
          double rate);

// An infant's voice: four actions more of the agent, and, where anybody hears, a mouth in what sounds around. Throws
// Status::kUnsupported for what is no infant.
void add_voice(Perception& agent, const mjModel& model, const AgentOptions& options, senses::Soundscape* soundscape);

}  // namespace mimo::env
