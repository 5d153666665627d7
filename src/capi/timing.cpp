#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_timing(const mimo_env* env, mimo_timing* timing) noexcept {
  return guard(env, [&] {
    const env::Timing& inner = open(env).world().timing();
    const auto of = [&](observation::Share share) { return inner.senses[static_cast<std::size_t>(share)]; };
    mimo_timing ours{};
    ours.steps = inner.steps;
    ours.total = inner.total;
    ours.physics = inner.physics;
    ours.touch = of(observation::Share::kTouch);
    ours.vision = of(observation::Share::kVision);
    ours.proprioception = of(observation::Share::kProprioception);
    ours.vestibular = of(observation::Share::kVestibular);
    ours.hearing = of(observation::Share::kHearing);
    write_described(timing, ours, "timing");
  });
}

mimo_status mimo_env_timing_reset(mimo_env* env) noexcept {
  return guard(env, [&] { open(env).world().reset_timing(); });
}

}  // extern "C"
