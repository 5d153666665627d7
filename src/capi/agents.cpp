// Agents, from their configs to plans.
#include <algorithm>
#include <optional>

#include "base/header.h"
#include "base/numbers.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/configs.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "scene/anatomy.h"

namespace mimo::capi {
namespace {

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
  return {resolve_bits(config.proprioception, MIMO_PROPRIOCEPTION_ALL, header::kProprioception, "proprioception"),
          config.limit_threshold};
}

senses::TouchOptions touch(const mimo_agent_config& config) {
  check_bits(config.touch, header::kTouch, "touch");
  senses::TouchOptions options;
  options.wanted = config.touch;
  senses::check_outputs(options);
  if (options.wanted == 0) return options;
  check_choice(config.touch_response, MIMO_RESPONSE_NEAREST, MIMO_RESPONSE_GAUSSIAN, "touch_response");
  check_choice(config.touch_frame, MIMO_FRAME_BODY, MIMO_FRAME_SKIN, "touch_frame");
  require(config.touch_slip_threshold >= 0 && std::isfinite(config.touch_slip_threshold),
          "touch_slip_threshold is {}, expected m/s, 0 or above", config.touch_slip_threshold);
  options.response = static_cast<senses::touch::Response>(config.touch_response);
  options.frame = static_cast<senses::TouchFrame>(config.touch_frame);
  options.scale = in_range(config.touch_scale, ranges::agent_config::touch_scale);
  options.slip_threshold = config.touch_slip_threshold;
  return options;
}

actuation::Options actuation(const mimo_agent_config& config) {
  check_choice(config.actuation, MIMO_ACTUATION_TORQUE, MIMO_ACTUATION_MUJOCO_MUSCLE, "actuation");
  check_flag(config.normalize_actions, "normalize_actions");
  actuation::Options options;
  options.mode = static_cast<actuation::Mode>(config.actuation);
  options.normalize = config.normalize_actions != 0;
  return options;
}

// Infants' only: the gears of other models may mean anything.
double strength(const mimo_agent_config& config) {
  const double given = in_range_or_zero(config.strength, ranges::agent_config::strength, "", "1");
  const double factor = given == 0 ? 1 : given;
  const bool has_motors = text(config.root).empty() && config.actuation != MIMO_ACTUATION_POSITION;
  require(factor == 1 || has_motors, "strength is {}, expected 1 with a root or MIMO_ACTUATION_POSITION", factor);
  return factor;
}

senses::VestibularOptions vestibular(const mimo_agent_config& config) {
  check_bits(config.vestibular, header::kVestibular, "vestibular");
  return {config.vestibular, text(config.vestibular_at)};
}

env::ReflexOptions reflexes(const mimo_agent_config& config) {
  constexpr std::uint32_t kAll = header::kReflex & ~MIMO_REFLEX_FELT;
  env::ReflexOptions options;
  check_bits(config.reflexes, header::kReflex | MIMO_REFLEX_ALL, "reflexes");
  options.wanted = resolve_bits(config.reflexes & ~MIMO_REFLEX_FELT, MIMO_REFLEX_ALL, kAll, "reflexes");
  options.felt = has_bit(config.reflexes, MIMO_REFLEX_FELT);
  options.where_possible = has_bit(config.reflexes, MIMO_REFLEX_ALL);
  return options;
}

senses::HearingOptions hearing(const mimo_agent_config& config) {
  check_bits(config.hearing, header::kHearing, "hearing");
  return {config.hearing};
}

env::AgentOptions agent_options(const mimo_agent_config& config) {
  using namespace ranges::agent_config;
  env::AgentOptions options;
  options.name = text(config.name);
  options.proprioception = proprioception(config);
  options.vestibular = vestibular(config);
  options.vision = vision(config.vision, "vision", {config.vision_width, vision_width},
                          {config.vision_height, vision_height}, {config.vision_fovy, vision_fovy});
  options.vision.foveation = in_range_or_zero(config.vision_foveation, vision_foveation, "", "none");
  options.touch = touch(config);
  options.hearing = hearing(config);
  check_flag(config.voice, "voice");
  options.voice = config.voice != 0;
  options.face = text(config.face);
  options.actuation = actuation(config);
  options.strength = strength(config);
  options.reflexes = reflexes(config);
  options.root = text(config.root);
  return options;
}

}  // namespace

mimo_agent_config default_agent_config() {
  const env::AgentOptions ours;
  mimo_agent_config config{};
  config.struct_size = sizeof config;
  config.name = "";
  config.body = blueprint::kUsualBody;
  config.orientation[0] = 1;
  config.proprioception = ours.proprioception.wanted;
  config.limit_threshold = ours.proprioception.limit_threshold;
  config.vestibular = ours.vestibular.wanted;
  config.vision = ours.vision.wanted;
  config.vision_width = static_cast<std::uint32_t>(ours.vision.width);
  config.vision_height = static_cast<std::uint32_t>(ours.vision.height);
  config.touch = ours.touch.wanted;
  config.touch_response = static_cast<std::int32_t>(ours.touch.response);
  config.touch_frame = static_cast<std::int32_t>(ours.touch.frame);
  config.touch_scale = ours.touch.scale;
  config.touch_slip_threshold = ours.touch.slip_threshold;
  return config;
}

mimo_agent_config default_agent_config(const scene::Scene& scene) {
  mimo_agent_config config = default_agent_config();
  const scene::UsualInfant usual = scene.usual_infant();
  config.body = usual.body;
  if (usual.muscles) config.actuation = MIMO_ACTUATION_MUSCLE;
  for (const header::Sense& sense : header::kSenses) {
    const std::vector<std::string>& senses = usual.senses;
    const bool has = senses.empty() || std::find(senses.begin(), senses.end(), sense.name) != senses.end();
    if (!has) config.*sense.bits = 0;
  }
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

blueprint::AgentPlan usual_agent(const scene::Scene& scene) { return plan_from(default_agent_config(scene)); }

blueprint::Blueprint ready_world(const std::string& scene) {
  scene::Source source;
  source.name = scene;
  blueprint::Blueprint blueprint(source);
  blueprint.edit([](blueprint::SceneEdit& edit) { edit.add_agents(usual_agent(edit.scene)); });
  return blueprint;
}

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
      note(edit, {{"call", "set_touch"}, {"agent", agent}, {"body", body}, {"spacing", spacing}});
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
