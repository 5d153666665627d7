#include "capi/agents.h"

#include <algorithm>

#include "capi/check.h"
#include "capi/guard.h"
#include "capi/pose.h"
#include "capi/structs.h"
#include "capi/vision.h"

namespace mimo::capi {
namespace {

senses::ProprioceptionOptions proprioception(const mimo_agent_config& config) {
  check_bits(config.proprioception, MIMO_PROPRIOCEPTION_ALL, "proprioception");
  require(config.limit_threshold > 0 && config.limit_threshold <= 10,
          "limit_threshold is {}, expected radians above 0 and up to 10", config.limit_threshold);
  const auto has = [&](std::uint32_t bit) { return (config.proprioception & bit) != 0; };
  senses::ProprioceptionOptions options;
  options.position = has(MIMO_PROPRIOCEPTION_POSITION);
  options.velocity = has(MIMO_PROPRIOCEPTION_VELOCITY);
  options.torque = has(MIMO_PROPRIOCEPTION_TORQUE);
  options.limit = has(MIMO_PROPRIOCEPTION_LIMIT);
  options.joint_torque = has(MIMO_PROPRIOCEPTION_JOINT_TORQUE);
  options.limit_threshold = config.limit_threshold;
  return options;
}

void check_choice(std::int32_t value, std::int32_t low, std::int32_t high, const char* argument) {
  require(value >= low && value <= high, "{} is {}, expected {} to {}", argument, value, low, high);
}

senses::TouchOptions touch(const mimo_agent_config& config) {
  constexpr std::uint32_t kAll = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE | MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE;
  check_bits(config.touch, kAll, "touch");
  check_reserved(config.touch_reserved, "touch_reserved");
  const auto has = [&](std::uint32_t bit) { return (config.touch & bit) != 0; };
  senses::TouchOptions options;
  options.force = has(MIMO_TOUCH_FORCE);
  options.normal_force = has(MIMO_TOUCH_NORMAL_FORCE);
  options.slip = has(MIMO_TOUCH_SLIP);
  options.friction_use = has(MIMO_TOUCH_FRICTION_USE);
  senses::check_outputs(options);
  if (!options.any()) return options;
  check_choice(config.touch_response, MIMO_TOUCH_NEAREST, MIMO_TOUCH_GAUSSIAN, "touch_response");
  check_choice(config.touch_frame, MIMO_FRAME_BODY, MIMO_FRAME_SKIN, "touch_frame");
  require(config.touch_scale >= 0.001 && config.touch_scale <= 1000, "touch_scale is {}, expected 0.001 to 1000",
          config.touch_scale);
  require(config.touch_slip_threshold >= 0 && std::isfinite(config.touch_slip_threshold),
          "touch_slip_threshold is {}, expected m/s, 0 or above", config.touch_slip_threshold);
  options.response = static_cast<senses::touch::Response>(config.touch_response);
  options.frame = static_cast<senses::TouchFrame>(config.touch_frame);
  options.scale = config.touch_scale;
  options.slip_threshold = config.touch_slip_threshold;
  return options;
}

actuation::Options actuation(const mimo_agent_config& config) {
  require(config.actuation <= MIMO_ACTUATION_MUJOCO_MUSCLE,
          "actuation is {}, expected a MIMO_ACTUATION_ constant, 0 to 3", config.actuation);
  check_flag(config.normalize_actions, "normalize_actions");
  actuation::Options options;
  options.mode = static_cast<actuation::Mode>(config.actuation);
  options.normalize = config.normalize_actions != 0;
  options.felt = (config.proprioception & MIMO_PROPRIOCEPTION_ACTUATION) != 0;
  options.effort = (config.proprioception & MIMO_PROPRIOCEPTION_EFFORT) != 0;
  return options;
}

env::AgentOptions agent_options(const mimo_agent_config& config) {
  check_flag(config.vestibular, "vestibular");
  env::AgentOptions options;
  options.name = text(config.name);
  options.proprioception = proprioception(config);
  options.vestibular = config.vestibular != 0;
  options.vision = vision({"vision", config.vision}, {"vision_width", config.vision_width},
                          {"vision_height", config.vision_height}, {"vision_fovy", config.vision_fovy});
  options.touch = touch(config);
  options.face = text(config.face);
  options.actuation = actuation(config);
  options.root = text(config.root);
  options.vestibular_at = text(config.vestibular_at);
  return options;
}

}  // namespace

mimo_agent_config default_agent_config() {
  mimo_agent_config config{};
  config.struct_size = sizeof config;
  config.name = "";
  config.body = "mitten";
  config.orientation[0] = 1;
  config.proprioception = MIMO_PROPRIOCEPTION_DEFAULT;
  config.vestibular = 1;
  config.limit_threshold = 0.035;
  config.vision = MIMO_VISION_RGB;
  config.vision_width = 256;
  config.vision_height = 256;
  config.touch = MIMO_TOUCH_FORCE;
  config.touch_response = MIMO_TOUCH_LINEAR;
  config.touch_frame = MIMO_FRAME_BODY;
  config.touch_scale = 1;
  config.touch_slip_threshold = senses::TouchOptions().slip_threshold;
  return config;
}

mimo_agent_config default_agent_config(const scene::Scene& scene) {
  const scene::UsualInfant usual = scene.usual_infant();
  mimo_agent_config config = default_agent_config();
  config.body = usual.body;
  if (usual.muscles) config.actuation = MIMO_ACTUATION_MUSCLE;
  if (usual.place) {
    std::copy(usual.place->position.begin(), usual.place->position.end(), config.position);
    std::copy(usual.place->orientation.begin(), usual.place->orientation.end(), config.orientation);
  }
  if (!usual.senses.proprioception) config.proprioception = 0;
  if (!usual.senses.vestibular) config.vestibular = 0;
  if (!usual.senses.vision) config.vision = 0;
  if (!usual.senses.touch) config.touch = 0;
  return config;
}

blueprint::AgentPlan plan_from(const mimo_agent_config& config) {
  blueprint::AgentPlan plan;
  plan.options = agent_options(config);
  plan.body = text(config.body);
  check_flag(config.place_given, "place_given");
  if (config.place_given != 0) plan.place = pose(config.position, config.orientation);
  if (config.acts != MIMO_ACT_NONE) check_bits(config.acts, MIMO_ACT_ALL, "acts");
  plan.acts = config.acts;
  return plan;
}

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_agent_config_init(mimo_agent_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_agent_config(), "config"); });
}

mimo_status mimo_scene_default_agent(const mimo_scene* scene, mimo_agent_config* config, size_t size) noexcept {
  return guard(
      scene, [&] { write_struct(config, size, default_agent_config(open(scene).blueprint.draft().scene), "config"); });
}

mimo_status mimo_scene_add_agent(mimo_scene* scene, const mimo_agent_config* config, int32_t* agent) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const mimo_agent_config defaults = default_agent_config(blueprint.draft().scene);
    const blueprint::AgentPlan plan = plan_from(read_struct(config, defaults, "config"));
    const std::size_t number = blueprint.edit([&](blueprint::Draft& draft) { return draft.add_agent(plan); });
    if (agent != nullptr) *agent = static_cast<int32_t>(number);
  });
}

mimo_status mimo_scene_add_agents(mimo_scene* scene, const mimo_agent_config* config, size_t* count) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const mimo_agent_config defaults = default_agent_config(blueprint.draft().scene);
    const blueprint::AgentPlan plan = plan_from(read_struct(config, defaults, "config"));
    const std::size_t added = blueprint.edit([&](blueprint::Draft& draft) { return draft.add_agents(plan); });
    if (count != nullptr) *count = added;
  });
}

mimo_status mimo_scene_set_touch(mimo_scene* scene, int32_t agent, const char* body, double spacing) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(spacing >= 0 && spacing <= 10, "spacing of body \"{}\" is {}, expected metres up to 10, or 0 for no skin",
            body == nullptr ? "(every)" : body, spacing);
    blueprint.edit([&](blueprint::Draft& draft) {
      if (body == nullptr) return draft.agents.set_touch(agent, spacing);
      draft.agents.set_touch(agent, body, spacing, draft.scene);
    });
  });
}

mimo_status mimo_scene_read_joint(mimo_scene* scene, int32_t agent, const char* joint) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const std::string name = text(joint);
    require(!name.empty(), "joint is {}, expected a name", joint == nullptr ? "NULL" : "\"\"");
    blueprint.edit([&](blueprint::Draft& draft) { draft.agents.read_joint(agent, name); });
  });
}

}  // extern "C"
