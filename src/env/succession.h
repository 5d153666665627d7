// A world that takes the place of another: the same agents in other bodies.
#pragma once

#include <memory>

#include "env/kit.h"
#include "env/world.h"

namespace mimo::env {

std::unique_ptr<World> make_world(const Kit& kit, const Services& services, const Identity& identity);

// Starts an episode in `next`, which goes on where the world was that it replaces (World::succeed). Throws what a reset
// throws, and then everything is as it was.
void take_over(std::unique_ptr<World>& place, std::unique_ptr<World> next, const std::uint64_t* seed,
               std::uint8_t* block);

}  // namespace mimo::env
