// The sensors of the skin.
#include "capi/check.h"
#include "capi/fields.h"
#include "capi/guard.h"
#include "capi/objects.h"

using namespace mimo;
using namespace mimo::capi;

extern "C" mimo_status mimo_env_touch_sensors(const mimo_env* env, size_t agent, int32_t* bodies, int32_t* geoms,
                                              double* positions, double* frames, size_t capacity,
                                              size_t* count) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world;
    check_agent(world.agents(), agent);
    describe_skin(world.agents()[agent].skin.get(), {bodies, geoms, positions, frames}, capacity, count);
  });
}
