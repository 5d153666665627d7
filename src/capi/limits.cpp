// Limits of an agent's senses.
#include <limits>

#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

constexpr std::uint32_t kLatest = 1000;
constexpr double kMost = std::numeric_limits<float>::max();  // so that no product leaves the range of a double

mimo_limits default_limits() {
  mimo_limits limits{};
  limits.struct_size = sizeof limits;
  limits.gain = 1;
  return limits;
}

observation::Limits limits_from(const mimo_limits& config) {
  require(config.delay <= kLatest, "delay is {}, expected up to {} steps", config.delay, kLatest);
  require(config.gain >= 0 && config.gain <= kMost, "gain is {}, expected a factor from 0 to {:.4g}", config.gain,
          kMost);
  require(config.noise >= 0 && config.noise <= kMost, "noise is {}, expected a deviation from 0 to {:.4g}",
          config.noise, kMost);
  require(config.blur == 0 || (config.blur >= 0.05 && config.blur <= 1000),
          "blur is {}, expected 0.05 to 1000 cycles per degree, or 0 for none", config.blur);
  return {config.gain, config.noise, config.blur, static_cast<int>(config.delay)};
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_limits_init(mimo_limits* limits, size_t size) noexcept {
  return guard([&] { write_struct(limits, size, default_limits(), "limits"); });
}

mimo_status mimo_scene_limit_sense(mimo_scene* scene, int32_t agent, const char* path,
                                   const mimo_limits* limits) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const std::string where = text(path);
    require(!where.empty(), "path is {}, expected that of a sense or field", path == nullptr ? "NULL" : "\"\"");
    const observation::Limits ours = limits_from(read_struct(limits, default_limits(), "limits"));
    blueprint.edit([&](blueprint::Draft& draft) { draft.agents.limit_sense(agent, where, ours); });
  });
}

}  // extern "C"
