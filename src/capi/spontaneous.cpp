// Spontaneous movements of worlds, alone and in batches.
#include "env/spontaneous.h"

#include "base/header.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/use.h"
#include "mimo/experimental/spontaneous.h"

namespace mimo::capi {
namespace {

std::uint32_t bits_from(std::uint32_t which) {
  return resolve_bits(which, MIMO_MOVEMENT_ALL, header::kMovement, "which");
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_spontaneous(const mimo_env* env, size_t agent, uint32_t which, float* actions,
                                 size_t count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    check_agent(world.agents(), agent);
    const std::uint32_t kinds = bits_from(which);
    require(actions != nullptr, "actions is NULL");
    check_exact(count, world.agents()[agent].actuation->size(), "count");
    env::require_spontaneous(world, agent);
    env::spontaneous(world, agent, kinds, {actions, count});
  });
}

mimo_status mimo_batch_spontaneous(const mimo_batch* batch, uint32_t which, float* actions, size_t count) noexcept {
  return guard(batch, [&] {
    const batch::Batch& worlds = open(batch).batch;
    worlds.require_idle();
    const std::uint32_t kinds = bits_from(which);
    require(actions != nullptr, "actions is NULL");
    const std::size_t of_world = worlds.world(0).action_size();
    check_exact(count, worlds.size() * of_world, "count");
    // All worlds have agents of the same kinds; where one is refused, nothing is written.
    for (std::size_t agent = 0; agent < worlds.world(0).agents().size(); ++agent) {
      env::require_spontaneous(worlds.world(0), agent);
    }
    for (std::size_t i = 0; i < worlds.size(); ++i) {
      const env::World& world = worlds.world(i);
      for (std::size_t agent = 0; agent < world.agents().size(); ++agent) {
        const env::Agent& infant = world.agents()[agent];
        env::spontaneous(world, agent, kinds,
                         {actions + i * of_world + infant.action_offset, infant.actuation->size()});
      }
    }
  });
}

}  // extern "C"
