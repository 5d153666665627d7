// How dense the sensors of the skin are.
#include <algorithm>

#include "base/format.h"
#include "capi/agents.h"
#include "capi/check.h"
#include "capi/fields.h"
#include "capi/guard.h"
#include "capi/objects.h"

namespace mimo::capi {
namespace {

void set_touch(SceneObject& object, std::int32_t agent, const char* body, double spacing) {
  env::AgentOptions& options = agent_at(object, agent);
  require(spacing >= 0 && spacing <= 10, "spacing of body \"{}\" is {}, expected metres up to 10, or 0 for no skin",
          body == nullptr ? "(every)" : body, spacing);
  if (body == nullptr) {
    options.touch.spacing.clear();
    options.touch.everywhere = spacing;
    return;
  }
  const std::vector<std::string> names = object.scene.body_names(options.prefix());
  const bool known = options.root.empty() && !names.empty();  // else only the compiled model tells
  if (known && std::find(names.begin(), names.end(), body) == names.end()) {
    fail(Status::kNotFound, "no body \"{}\"; the infant has: {}", body, join(names, ", "));
  }
  options.touch.spacing[body] = spacing;
}

}  // namespace
}  // namespace mimo::capi

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

extern "C" mimo_status mimo_scene_set_touch(mimo_scene* scene, int32_t agent, const char* body,
                                            double spacing) noexcept {
  return guard(scene, [&] { set_touch(open(scene), agent, body, spacing); });
}
