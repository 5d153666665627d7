// The skin: how dense its sensors are, and where they sit.
#include <algorithm>

#include "base/format.h"
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"

namespace mimo::capi {
namespace {

using senses::touch::Sensor;

struct Arrays {
  std::int32_t *bodies, *geoms;
  double *positions, *frames;

  bool any() const { return bodies != nullptr || geoms != nullptr || positions != nullptr || frames != nullptr; }
};

void describe(Span<const Sensor> sensors, const Arrays& to) {
  using Positions = Eigen::Map<Eigen::Vector3d>;
  using Frames = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (to.bodies != nullptr) to.bodies[i] = sensors[i].body;
    if (to.geoms != nullptr) to.geoms[i] = sensors[i].geom;
    if (to.positions != nullptr) Positions(to.positions + 3 * i) = sensors[i].position;
    if (to.frames != nullptr) Frames(to.frames + MIMO_TOUCH_FRAME_VALUES * i) = sensors[i].frame;
  }
}

void set_touch(SceneObject& object, std::int32_t agent, const char* body, double spacing) {
  require(agent >= 0 && static_cast<std::size_t>(agent) < object.agents.size(), "agent is {}, but there are {} agents",
          agent, object.agents.size());
  env::AgentOptions& options = object.agents[static_cast<std::size_t>(agent)];
  require(spacing >= 0 && spacing <= 10, "spacing of body \"{}\" is {}, expected metres up to 10, or 0 for no skin",
          body == nullptr ? "(every)" : body, spacing);
  if (body == nullptr) {
    options.touch.spacing.clear();
    options.touch.everywhere = spacing;
    return;
  }
  const std::vector<std::string> names = object.scene.body_names(options.prefix());
  if (std::find(names.begin(), names.end(), body) == names.end()) {
    fail(Status::kNotFound, "no body \"{}\"; the infant has: {}", body, fmt::join(names, ", "));
  }
  options.touch.spacing[body] = spacing;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

// NOLINTBEGIN(readability-non-const-parameter): they are written to, through Arrays
extern "C" mimo_status mimo_env_touch_sensors(const mimo_env* env, size_t agent, int32_t* bodies, int32_t* geoms,
                                              double* positions, double* frames, size_t capacity,
                                              size_t* count) noexcept {
  // NOLINTEND(readability-non-const-parameter)
  return guard([&] {
    const auto& agents = open(env).world.agents();
    require(agent < agents.size(), "agent is {}, but there are {} agents", agent, agents.size());
    const auto& skin = agents[agent].skin;
    const Span<const Sensor> sensors = skin == nullptr ? Span<const Sensor>() : Span<const Sensor>(skin->sensors());
    check_length<double[MIMO_TOUCH_FRAME_VALUES]>(capacity, "capacity");
    if (count != nullptr) *count = sensors.size();
    const Arrays arrays{bodies, geoms, positions, frames};
    if (arrays.any() && capacity < sensors.size()) {
      fail(Status::kBufferTooSmall, "capacity is {}, but there are {} sensors", capacity, sensors.size());
    }
    describe(sensors, arrays);
  });
}

extern "C" mimo_status mimo_scene_set_touch(mimo_scene* scene, int32_t agent, const char* body,
                                            double spacing) noexcept {
  return guard([&] { set_touch(open(scene), agent, body, spacing); });
}
