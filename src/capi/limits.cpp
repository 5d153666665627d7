// Limits of an agent's senses, and of the paths to its motors.
#include <cmath>
#include <limits>

#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

constexpr double kMost = std::numeric_limits<float>::max();  // so that no product leaves the range of a double

mimo_limits default_limits() {
  mimo_limits limits{};
  limits.struct_size = sizeof limits;
  limits.gain = 1;
  return limits;
}

observation::Limits limits_from(const mimo_limits& config) {
  check_reserved(config.reserved, "reserved");
  in_range(config.delay, ranges::limits::delay, " seconds");
  require(config.gain >= 0 && config.gain <= kMost, "gain is {}, expected a factor from 0 to {:.4g}", config.gain,
          kMost);
  require(config.noise >= 0 && config.noise <= kMost, "noise is {}, expected a deviation from 0 to {:.4g}",
          config.noise, kMost);
  in_range_or_zero(config.blur, ranges::limits::blur, " cycles per degree", "none");
  require(ranges::limits::signal_noise.has(config.signal_noise),
          "signal_noise is {}, expected a share of the value from 0 to {}", config.signal_noise,
          ranges::limits::signal_noise.high);
  return {config.gain, config.noise, config.blur, config.delay, config.signal_noise};
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_limits_init(mimo_limits* limits, size_t size) noexcept {
  return guard([&] { write_struct(limits, size, default_limits(), "limits"); });
}

mimo_status mimo_scene_limit_sense(mimo_scene* scene, size_t agent, const char* path,
                                   const mimo_limits* limits) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const std::string where = text(path);
    require(!where.empty(), "path is {}, expected the path of a sense or field", path == nullptr ? "NULL" : "\"\"");
    const mimo_limits given = read_struct(limits, default_limits(), "limits");
    const observation::Limits ours = limits_from(given);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.agents.limit_sense(agent, where, ours);
      note(edit, {{"call", "limit_sense"}, {"agent", agent}, {"path", where}, {"limits", json_of(given)}});
    });
  });
}

mimo_status mimo_scene_limit_motor(mimo_scene* scene, size_t agent, const char* path,
                                   const mimo_limits* limits) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(path != nullptr, "path is NULL, expected the path of a motor, a part of the body, or \"\" for all");
    const mimo_limits given = read_struct(limits, default_limits(), "limits");
    const observation::Limits ours = limits_from(given);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.agents.limit_motor(agent, path, ours);
      note(edit, {{"call", "limit_motor"}, {"agent", agent}, {"path", path}, {"limits", json_of(given)}});
    });
  });
}

}  // extern "C"
