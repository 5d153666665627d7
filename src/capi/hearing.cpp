// Sounds that a host plays.
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"

namespace mimo::capi {
namespace {

// A world, or attached senses, play what a caller gives.
template <typename Plays>
void play(Plays& plays, const char* body, const float* samples, std::size_t count, double rate) {
  const std::string name = text(body);
  require(!name.empty(), "body is {}, expected a name", body == nullptr ? "NULL" : "\"\"");
  plays.play(name, array(samples, count, "samples"), rate);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_scene_set_sources(mimo_scene* scene, size_t count, double seconds) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(count >= 1 && count <= 64, "count is {}, expected 1 to 64 bodies that play at once", count);
    require(seconds >= 0.01 && seconds <= 600, "seconds is {}, expected 0.01 to 600", seconds);
    blueprint.edit([&](blueprint::Draft& draft) { draft.play = {count, seconds}; });
  });
}

mimo_status mimo_env_play(mimo_env* env, const char* body, const float* samples, size_t count, double rate) noexcept {
  return guard(env, [&] { play(open(env).world(), body, samples, count, rate); });
}

mimo_status mimo_senses_play(mimo_senses* senses, const char* body, const float* samples, size_t count,
                             double rate) noexcept {
  return guard(senses, [&] { play(open(senses).attached, body, samples, count, rate); });
}

}  // extern "C"
