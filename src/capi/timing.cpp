#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_timing(const mimo_env* env, mimo_timing* timing) noexcept {
  return guard(env, [&] {
    const env::Timing& inner = open(env).world.timing();
    const auto of = [&](observation::Part part) { return inner.senses[static_cast<std::size_t>(part)]; };
    mimo_timing ours{};
    ours.steps = inner.steps;
    ours.total = inner.total;
    ours.physics = inner.physics;
    ours.touch = of(observation::Part::kTouch);
    ours.vision = of(observation::Part::kVision);
    ours.proprioception = of(observation::Part::kProprioception);
    ours.vestibular = of(observation::Part::kVestibular);
    write_described(timing, ours, "timing");
  });
}

mimo_status mimo_env_timing_reset(mimo_env* env) noexcept {
  return guard(env, [&] { open(env).world.reset_timing(); });
}

}  // extern "C"
