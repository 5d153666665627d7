// The state of one world.
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/use.h"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_state_size(const mimo_env* env, size_t* bytes) noexcept {
  return guard(env, [&] { out(bytes, "bytes") = open(env).world().state_bytes(); });
}

mimo_status mimo_env_state_save(const mimo_env* env, void* state, size_t state_bytes) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    auto* start = static_cast<std::uint8_t*>(state);
    require(start != nullptr, "state is NULL");
    check_buffer(start, state_bytes, world.state_bytes(), "state");
    world.save({start, world.state_bytes()});
  });
}

mimo_status mimo_env_state_load(mimo_env* env, const void* state, size_t state_bytes,
                                mimo_load_report* report) noexcept {
  return guard(env, [&] {
    EnvObject& object = open(env);
    const auto* start = static_cast<const std::uint8_t*>(state);
    require(start != nullptr, "state is NULL");
    load_and_report(report, object.loaded, [&] { return object.world().load({start, state_bytes}); });
  });
}

}  // extern "C"
