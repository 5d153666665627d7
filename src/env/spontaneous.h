// The spontaneous movements of a world's infants, as actions.
#pragma once

#include <cstdint>

#include "base/span.h"

namespace mimo::env {

struct Agent;
class World;

// Gives an infant that is moved by torques its movements.
void add_spontaneous(Agent& infant);

// Throws Status::kUnsupported for an agent that is no infant, or is not moved by torques.
void require_spontaneous(const World& world, std::size_t agent);

// Of one such agent, for the next step: as many numbers as it has actions, within their bounds. `which` are
// MIMO_MOVEMENT_ bits.
void spontaneous(const World& world, std::size_t agent, std::uint32_t which, Span<float> actions);

}  // namespace mimo::env
