// What surrounds infants in a world: its things (how warm, rough and loud they are) and its sounds.
#pragma once

#include <vector>

#include "env/options.h"
#include "env/perception.h"
#include "observation/observer.h"
#include "senses/touch/felt.h"

namespace mimo::senses {
class Soundscape;
}
namespace mimo::sound {
struct Solid;
}

namespace mimo::env {

// Infants are as warm as naked skin in the room; all else is as warm as the room and of plastic, unless it is told.
// Throws Status::kNotFound for a body that the model does not have.
senses::touch::ThingsPtr things_of(const mjModel& model, const std::vector<AgentOptions>& agents,
                                   const EnvOptions& options);

// How things sound when struck, in the same way.
std::shared_ptr<const std::vector<sound::Solid>> solids_of(const mjModel& model,
                                                           const std::vector<AgentOptions>& agents,
                                                           const EnvOptions& options);

// Throws Status::kNotFound for a material that is not known, naming those that are.
void check_material(const std::string& name);
// The index-th one that is known, null past the last. Static string.
const char* material_name(std::size_t index);

// Sounds in a world, for agents that hear and hosts that play.

// Null if no agent hears; otherwise the observer owns it, before the senses that hear.
senses::Soundscape* add_soundscape(observation::Observer& observer, const mjModel& model, double tick,
                                   const std::vector<AgentOptions>& agents, const EnvOptions& options);

// Throws Status::kUnsupported if no agent hears, kNotFound for a missing body, and what Soundscape::play
// does; samples are finite numbers then.
void play(senses::Soundscape* soundscape, const mjModel& model, const std::string& body, Span<const float> samples,
          double rate);

// An infant's voice: four actions more of the agent, and, where anybody hears, a mouth in what sounds around. Throws
// Status::kUnsupported for what is no infant.
void add_voice(Perception& agent, const mjModel& model, const AgentOptions& options, senses::Soundscape* soundscape);

}  // namespace mimo::env
