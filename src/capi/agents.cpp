// Agents, from their configs to plans.
#include "capi/agents.h"

#include <algorithm>
#include <optional>

#include "blueprint/agents.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/growth.h"
#include "capi/objects.h"
#include "capi/pose.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "capi/vision.h"
#include "scene/groups.h"

namespace mimo::capi {
namespace {

std::uint32_t proprioception_bits(const mimo_agent_config& config) {
  constexpr std::uint32_t kKnown =
      MIMO_PROPRIOCEPTION_ACTUATION | MIMO_PROPRIOCEPTION_VELOCITY | MIMO_PROPRIOCEPTION_TORQUE |
      MIMO_PROPRIOCEPTION_LIMIT | MIMO_PROPRIOCEPTION_JOINT_TORQUE | MIMO_PROPRIOCEPTION_POSITION |
      MIMO_PROPRIOCEPTION_EFFORT | MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY | MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY |
      MIMO_PROPRIOCEPTION_TENDON_ORGAN | MIMO_PROPRIOCEPTION_JOINT_RECEPTOR;
  return resolve_bits(config.proprioception, MIMO_PROPRIOCEPTION_ALL, kKnown, "proprioception");
}

// scene::Group bits.
std::uint32_t acts(const mimo_agent_config& config) {
  if ((config.acts & MIMO_ACT_NONE) == 0) return resolve_bits(config.acts, MIMO_ACT_ALL, scene::kAllGroups, "acts");
  require(config.acts == MIMO_ACT_NONE, "acts is {:#x}, expected MIMO_ACT_NONE alone or parts of the body",
          config.acts);
  return scene::kNoGroup;
}

senses::ProprioceptionOptions proprioception(const mimo_agent_config& config) {
  require(config.limit_threshold > 0 && config.limit_threshold <= 10,
          "limit_threshold is {}, expected radians above 0 and up to 10", config.limit_threshold);
  const std::uint32_t wanted = proprioception_bits(config);
  const auto has = [wanted](std::uint32_t bit) { return (wanted & bit) != 0; };
  senses::ProprioceptionOptions options;
  options.position = has(MIMO_PROPRIOCEPTION_POSITION);
  options.velocity = has(MIMO_PROPRIOCEPTION_VELOCITY);
  options.torque = has(MIMO_PROPRIOCEPTION_TORQUE);
  options.limit = has(MIMO_PROPRIOCEPTION_LIMIT);
  options.joint_torque = has(MIMO_PROPRIOCEPTION_JOINT_TORQUE);
  options.limit_threshold = config.limit_threshold;
  options.receptors = {has(MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY), has(MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY),
                       has(MIMO_PROPRIOCEPTION_TENDON_ORGAN), has(MIMO_PROPRIOCEPTION_JOINT_RECEPTOR)};
  return options;
}

senses::TouchOptions touch(const mimo_agent_config& config) {
  constexpr std::uint32_t kAll = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE | MIMO_TOUCH_SLIP |
                                 MIMO_TOUCH_FRICTION_USE | MIMO_TOUCH_SA1 | MIMO_TOUCH_RA | MIMO_TOUCH_PC |
                                 MIMO_TOUCH_SA2 | MIMO_TOUCH_TEMPERATURE | MIMO_TOUCH_COLD | MIMO_TOUCH_WARM |
                                 MIMO_TOUCH_NOCICEPTION_FAST | MIMO_TOUCH_NOCICEPTION_SLOW | MIMO_TOUCH_UNITS;
  check_bits(config.touch, kAll, "touch");
  const auto has = [&](std::uint32_t bit) { return (config.touch & bit) != 0; };
  senses::TouchOptions options;
  options.force = has(MIMO_TOUCH_FORCE);
  options.normal_force = has(MIMO_TOUCH_NORMAL_FORCE);
  options.slip = has(MIMO_TOUCH_SLIP);
  options.friction_use = has(MIMO_TOUCH_FRICTION_USE);
  options.receptors = {has(MIMO_TOUCH_SA1),
                       has(MIMO_TOUCH_RA),
                       has(MIMO_TOUCH_PC),
                       has(MIMO_TOUCH_SA2),
                       has(MIMO_TOUCH_TEMPERATURE),
                       has(MIMO_TOUCH_COLD),
                       has(MIMO_TOUCH_WARM),
                       has(MIMO_TOUCH_NOCICEPTION_FAST),
                       has(MIMO_TOUCH_NOCICEPTION_SLOW),
                       has(MIMO_TOUCH_UNITS)};
  senses::check_outputs(options);
  if (!options.any()) return options;
  check_choice(config.touch_response, MIMO_RESPONSE_NEAREST, MIMO_RESPONSE_GAUSSIAN, "touch_response");
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
  check_choice(config.actuation, MIMO_ACTUATION_TORQUE, MIMO_ACTUATION_MUJOCO_MUSCLE, "actuation");
  check_flag(config.normalize_actions, "normalize_actions");
  actuation::Options options;
  options.mode = static_cast<actuation::Mode>(config.actuation);
  options.normalize = config.normalize_actions != 0;
  const std::uint32_t felt = proprioception_bits(config);
  options.felt = (felt & MIMO_PROPRIOCEPTION_ACTUATION) != 0;
  options.effort = (felt & MIMO_PROPRIOCEPTION_EFFORT) != 0;
  return options;
}

senses::VestibularOptions vestibular(const mimo_agent_config& config) {
  constexpr std::uint32_t kAll = MIMO_VESTIBULAR_ACCELERATION | MIMO_VESTIBULAR_ANGULAR_VELOCITY |
                                 MIMO_VESTIBULAR_CANALS | MIMO_VESTIBULAR_OTOLITHS | MIMO_VESTIBULAR_GRAVITY;
  check_bits(config.vestibular, kAll, "vestibular");
  senses::VestibularOptions options;
  options.acceleration = (config.vestibular & MIMO_VESTIBULAR_ACCELERATION) != 0;
  options.angular_velocity = (config.vestibular & MIMO_VESTIBULAR_ANGULAR_VELOCITY) != 0;
  options.labyrinth.canals = (config.vestibular & MIMO_VESTIBULAR_CANALS) != 0;
  options.labyrinth.otoliths = (config.vestibular & MIMO_VESTIBULAR_OTOLITHS) != 0;
  options.labyrinth.gravity = (config.vestibular & MIMO_VESTIBULAR_GRAVITY) != 0;
  options.at = text(config.vestibular_at);
  return options;
}

env::ReflexOptions reflexes(const mimo_agent_config& config) {
  constexpr std::uint32_t kAll = MIMO_REFLEX_PALMAR_GRASP | MIMO_REFLEX_PLANTAR_GRASP | MIMO_REFLEX_ROOTING |
                                 MIMO_REFLEX_MORO | MIMO_REFLEX_ASYMMETRIC_TONIC_NECK | MIMO_REFLEX_STEPPING |
                                 MIMO_REFLEX_WITHDRAWAL;
  env::ReflexOptions options;
  check_bits(config.reflexes, kAll | MIMO_REFLEX_ALL | MIMO_REFLEX_FELT, "reflexes");
  options.wanted = resolve_bits(config.reflexes & ~MIMO_REFLEX_FELT, MIMO_REFLEX_ALL, kAll, "reflexes");
  options.felt = (config.reflexes & MIMO_REFLEX_FELT) != 0;
  options.where_possible = (config.reflexes & MIMO_REFLEX_ALL) != 0;
  return options;
}

senses::HearingOptions hearing(const mimo_agent_config& config) {
  check_bits(config.hearing, MIMO_HEARING_EARS | MIMO_HEARING_BANDS, "hearing");
  return {(config.hearing & MIMO_HEARING_EARS) != 0, (config.hearing & MIMO_HEARING_BANDS) != 0};
}

env::AgentOptions agent_options(const mimo_agent_config& config) {
  env::AgentOptions options;
  options.name = text(config.name);
  options.proprioception = proprioception(config);
  options.vestibular = vestibular(config);
  options.vision = vision({"vision", config.vision}, {"vision_width", config.vision_width},
                          {"vision_height", config.vision_height}, {"vision_fovy", config.vision_fovy});
  options.vision.foveation = foveation(config.vision_foveation, "vision_foveation");
  options.touch = touch(config);
  options.hearing = hearing(config);
  check_flag(config.voice, "voice");
  options.voice = config.voice != 0;
  options.face = text(config.face);
  options.actuation = actuation(config);
  options.reflexes = reflexes(config);
  options.root = text(config.root);
  return options;
}

std::uint32_t bit_if(bool wanted, std::uint32_t bit) { return wanted ? bit : 0; }

std::uint32_t proprioception_bits(const env::AgentOptions& options) {
  const senses::ProprioceptionOptions& felt = options.proprioception;
  return bit_if(felt.position, MIMO_PROPRIOCEPTION_POSITION) | bit_if(felt.velocity, MIMO_PROPRIOCEPTION_VELOCITY) |
         bit_if(felt.torque, MIMO_PROPRIOCEPTION_TORQUE) | bit_if(felt.limit, MIMO_PROPRIOCEPTION_LIMIT) |
         bit_if(felt.joint_torque, MIMO_PROPRIOCEPTION_JOINT_TORQUE) |
         bit_if(options.actuation.felt, MIMO_PROPRIOCEPTION_ACTUATION) |
         bit_if(options.actuation.effort, MIMO_PROPRIOCEPTION_EFFORT);
}

void write_vision(const senses::VisionOptions& options, mimo_agent_config& config) {
  config.vision = bit_if(options.rgb, MIMO_VISION_RGB) | bit_if(options.depth, MIMO_VISION_DEPTH) |
                  bit_if(options.segmentation, MIMO_VISION_SEGMENTATION);
  config.vision_width = static_cast<std::uint32_t>(options.width);
  config.vision_height = static_cast<std::uint32_t>(options.height);
  config.vision_fovy = options.fovy;
  config.vision_foveation = options.foveation;
}

void write_touch(const senses::TouchOptions& options, mimo_agent_config& config) {
  config.touch = bit_if(options.force, MIMO_TOUCH_FORCE) | bit_if(options.normal_force, MIMO_TOUCH_NORMAL_FORCE) |
                 bit_if(options.slip, MIMO_TOUCH_SLIP) | bit_if(options.friction_use, MIMO_TOUCH_FRICTION_USE);
  config.touch_response = static_cast<std::int32_t>(options.response);
  config.touch_frame = static_cast<std::int32_t>(options.frame);
  config.touch_scale = options.scale;
  config.touch_slip_threshold = options.slip_threshold;
}

// Outlives the plan that it stands in.
const char* lasting_body(const std::string& body) {
  for (std::size_t i = 0; const char* known = scene::built_in_body(i); ++i) {
    if (body == known) return known;
  }
  return "scene";
}

// Of a plan that is nobody's yet: it has no name, no root and no place of its own.
mimo_agent_config config_from(const blueprint::AgentPlan& plan) {
  mimo_agent_config config{};
  config.struct_size = sizeof config;
  config.name = "";
  config.body = lasting_body(plan.body);
  config.orientation[0] = 1;
  config.proprioception = proprioception_bits(plan.options);
  config.limit_threshold = plan.options.proprioception.limit_threshold;
  const senses::VestibularOptions& balance = plan.options.vestibular;
  config.vestibular = bit_if(balance.acceleration, MIMO_VESTIBULAR_ACCELERATION) |
                      bit_if(balance.angular_velocity, MIMO_VESTIBULAR_ANGULAR_VELOCITY);
  config.actuation = static_cast<std::int32_t>(plan.options.actuation.mode);
  write_vision(plan.options.vision, config);
  write_touch(plan.options.touch, config);
  return config;
}

}  // namespace

mimo_agent_config default_agent_config() {
  const blueprint::AgentPlan usual;  // a temporary is warned of by GCC with its thread sanitizer
  return config_from(usual);
}

mimo_agent_config default_agent_config(const scene::Scene& scene) {
  mimo_agent_config config = config_from(blueprint::usual_agent(scene));
  if (const std::optional<document::Pose> place = scene.free_place()) {
    std::copy(place->position.begin(), place->position.end(), config.position);
    std::copy(place->orientation.begin(), place->orientation.end(), config.orientation);
  }
  return config;
}

namespace {

blueprint::AgentPlan plan_from(const mimo_agent_config& config) {
  blueprint::AgentPlan plan;
  plan.options = agent_options(config);
  plan.body = text(config.body);
  check_choice(config.place, MIMO_PLACE_SCENE, MIMO_PLACE_LOWEST, "place");
  if (config.place != MIMO_PLACE_SCENE) {
    plan.place = {pose(config.position, config.orientation), static_cast<document::Anchor>(config.place)};
  }
  plan.acts = acts(config);
  if (config.growth != nullptr) plan.growth = growth_from(*config.growth, "growth");
  return plan;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_agent_config_init(mimo_agent_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_agent_config(), "config"); });
}

mimo_status mimo_scene_default_agent(const mimo_scene* scene, mimo_agent_config* config, size_t size) noexcept {
  return guard(scene, [&] {
    write_struct(config, size, default_agent_config(open(scene).blueprint.current().scene), "config");
  });
}

mimo_status mimo_scene_add_agent(mimo_scene* scene, const mimo_agent_config* config, size_t* agent) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const mimo_agent_config defaults = default_agent_config(blueprint.current().scene);
    const mimo_agent_config given = read_struct(config, defaults, "config");
    const blueprint::AgentPlan plan = plan_from(given);
    const std::size_t number = blueprint.edit([&](blueprint::SceneEdit& edit) {
      note(edit, call_of_agents("add_agent", given));
      return edit.add_agent(plan);
    });
    if (agent != nullptr) *agent = number;
  });
}

mimo_status mimo_scene_add_agents(mimo_scene* scene, const mimo_agent_config* config, size_t* count) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const mimo_agent_config defaults = default_agent_config(blueprint.current().scene);
    const mimo_agent_config given = read_struct(config, defaults, "config");
    const blueprint::AgentPlan plan = plan_from(given);
    const std::size_t added = blueprint.edit([&](blueprint::SceneEdit& edit) {
      note(edit, call_of_agents("add_agents", given));
      return edit.add_agents(plan);
    });
    if (count != nullptr) *count = added;
  });
}

mimo_status mimo_scene_set_touch(mimo_scene* scene, size_t agent, const char* body, double spacing) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(spacing >= 0 && spacing <= 10, "spacing of body \"{}\" is {}, expected metres up to 10, or 0 for no skin",
            body == nullptr ? "(every)" : body, spacing);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      note(edit, {{"call", "set_touch"}, {"agent", agent}, {"body", text_or_null(body)}, {"spacing", spacing}});
      if (body == nullptr) return edit.agents.set_touch(agent, spacing);
      edit.agents.set_touch(agent, body, spacing, edit.scene);
    });
  });
}

mimo_status mimo_scene_read_joint(mimo_scene* scene, size_t agent, const char* joint) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const std::string name = text(joint);
    require(!name.empty(), "joint is {}, expected a name", joint == nullptr ? "NULL" : "\"\"");
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.agents.read_joint(agent, name);
      note(edit, {{"call", "read_joint"}, {"agent", agent}, {"joint", name}});
    });
  });
}

}  // extern "C"
