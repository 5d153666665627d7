#include "capi/agents.h"

#include <algorithm>
#include <optional>

#include "capi/check.h"
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
  constexpr std::uint32_t kForces = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE;
  check_bits(config.touch, kForces | MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE, "touch");
  check_reserved(config.touch_reserved, "touch_reserved");
  require((config.touch & kForces) != kForces,
          "touch is {:#x}: MIMO_TOUCH_FORCE and MIMO_TOUCH_NORMAL_FORCE exclude each other", config.touch);
  const auto has = [&](std::uint32_t bit) { return (config.touch & bit) != 0; };
  senses::TouchOptions options;
  options.force = has(MIMO_TOUCH_FORCE);
  options.normal_force = has(MIMO_TOUCH_NORMAL_FORCE);
  options.slip = has(MIMO_TOUCH_SLIP);
  options.friction_use = has(MIMO_TOUCH_FRICTION_USE);
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
  check_plain_name(options.name);
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

// Where the scene says nothing, everything is on.
mimo_agent_config default_agent_config(const scene::Scene& scene) {
  mimo_agent_config config = default_agent_config();
  config.body = scene.usual_body();
  if (scene.actuation() == "muscle") config.actuation = MIMO_ACTUATION_MUSCLE;
  if (const std::optional<scene::Pose> place = scene.free_place()) {
    std::copy(place->position.begin(), place->position.end(), config.position);
    std::copy(place->orientation.begin(), place->orientation.end(), config.orientation);
  }
  const std::string senses = " " + scene.senses() + " ";
  if (senses == "  ") return config;
  const auto has = [&](const char* word) { return senses.find(" " + std::string(word) + " ") != std::string::npos; };
  if (!has("proprioception")) config.proprioception = 0;
  if (!has("vestibular")) config.vestibular = 0;
  if (!has("vision")) config.vision = 0;
  if (!has("touch")) config.touch = 0;
  return config;
}

void check_plain_name(const std::string& name) {
  // Not isalnum, whose letters depend on the host's locale.
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  });
  require(plain, "name is \"{}\", expected letters, digits, '_', '-' and '.'", name);
}

scene::Pose pose(const double (&position)[3], const double (&orientation)[4]) {
  check_finite(position, 3, "position");
  check_finite(orientation, 4, "orientation");
  const double square = orientation[0] * orientation[0] + orientation[1] * orientation[1] +
                        orientation[2] * orientation[2] + orientation[3] * orientation[3];
  require(square > 1e-18, "orientation is zero, expected a quaternion w x y z");
  scene::Pose result;
  std::copy(std::begin(position), std::end(position), result.position.begin());
  std::copy(std::begin(orientation), std::end(orientation), result.orientation.begin());
  return result;
}

env::AgentOptions& agent_at(SceneObject& object, std::int32_t agent) {
  const std::size_t count = object.agents.size();
  require(agent >= 0 && static_cast<std::size_t>(agent) < count, "agent is {}, but there are {} agents", agent, count);
  return object.agents[static_cast<std::size_t>(agent)];
}

std::size_t add_agent(SceneObject& object, const mimo_agent_config& config) {
  env::AgentOptions options = agent_options(config);
  for (const env::AgentOptions& other : object.agents) {
    require(other.name != options.name, "name: there is an agent \"{}\" already", options.name);
    require(!other.name.empty() && !options.name.empty(), "name is \"\", but each of several agents needs a name");
  }
  check_flag(config.place_given, "place_given");
  if (config.acts != MIMO_ACT_NONE) check_bits(config.acts, MIMO_ACT_ALL, "acts");
  object.agents.reserve(object.agents.size() + 1);
  const std::string body = text(config.body);
  require(options.root.empty() || body == "scene", "root is \"{}\" and body is \"{}\"; a root needs body \"scene\"",
          options.root, body);
  if (!options.root.empty()) {
    require(config.acts == 0 || config.acts == MIMO_ACT_NONE,
            "acts is {:#x}, but its parts are those of infants; 0 or MIMO_ACT_NONE goes with a root", config.acts);
    options.actuation.none = config.acts == MIMO_ACT_NONE;
  } else if (body != "scene") {
    const bool placed = config.place_given != 0;
    const scene::Pose place = placed ? pose(config.position, config.orientation) : scene::Pose{};
    object.scene.add_body(body, options.prefix(), placed ? &place : nullptr, config.acts);
  } else {
    object.scene.choose_motors(options.prefix(), config.acts);
  }
  object.agents.push_back(std::move(options));  // in reserved room: fails no more, now that the scene has the body
  return object.agents.size() - 1;
}

std::size_t add_agents(SceneObject& object, const mimo_agent_config& config) {
  std::vector<std::string> names = object.scene.infants();
  const std::string given = text(config.name);
  if (names.empty()) {
    names.push_back(given);
  } else {
    require(given.empty(), "name is \"{}\", but the scene names its infants itself", given);
  }
  require(config.place_given == 0 || names.size() == 1, "place_given is {}, but each of {} infants has its own place",
          config.place_given, names.size());
  SceneObject changed = object;
  for (const std::string& name : names) {
    mimo_agent_config own = config;
    own.name = name.c_str();
    add_agent(changed, own);
  }
  object = std::move(changed);
  return names.size();
}

}  // namespace mimo::capi
