#include <algorithm>
#include <cctype>

#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

constexpr std::uint32_t kLargestPicture = 4096;

mimo_scene_config default_scene_config() {
  mimo_scene_config config{};
  config.struct_size = sizeof config;
  return config;
}

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

mimo_object_config default_object_config() {
  mimo_object_config config{};
  config.struct_size = sizeof config;
  config.shape = MIMO_SHAPE_SPHERE;
  config.size[0] = 0.04;
  config.orientation[0] = 1;
  config.mass = 0.1;
  config.rgba[0] = 0.9;
  config.rgba[1] = 0.2;
  config.rgba[2] = 0.2;
  config.rgba[3] = 1;
  return config;
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

scene::Source source(const mimo_scene_config& config) {
  scene::Source source{text(config.name), text(config.file), text(config.xml), text(config.model_dir)};
  const int given = !source.name.empty() + !source.file.empty() + !source.xml.empty();
  require(given <= 1, "config: name \"{}\", file \"{}\" and xml exclude each other, {} of them are set", source.name,
          source.file, given);
  return source;
}

void check_agent_name(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
  require(plain, "name is \"{}\", expected letters, digits, '_', '-' and '.'", name);
}

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
  options.actuation = has(MIMO_PROPRIOCEPTION_ACTUATION);
  options.joint_torque = has(MIMO_PROPRIOCEPTION_JOINT_TORQUE);
  options.limit_threshold = config.limit_threshold;
  return options;
}

senses::VisionOptions vision(const mimo_agent_config& config) {
  check_bits(config.vision, MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION, "vision");
  const auto has = [&](std::uint32_t bit) { return (config.vision & bit) != 0; };
  senses::VisionOptions options;
  options.rgb = has(MIMO_VISION_RGB);
  options.depth = has(MIMO_VISION_DEPTH);
  options.segmentation = has(MIMO_VISION_SEGMENTATION);
  if (!options.any()) return options;
  require(config.vision_width >= 1 && config.vision_width <= kLargestPicture, "vision_width is {}, expected 1 to {}",
          config.vision_width, kLargestPicture);
  require(config.vision_height >= 1 && config.vision_height <= kLargestPicture, "vision_height is {}, expected 1 to {}",
          config.vision_height, kLargestPicture);
  require(config.vision_fovy == 0 || (config.vision_fovy >= 1 && config.vision_fovy <= 170),
          "vision_fovy is {}, expected 1 to 170 degrees, or 0 for the camera's own", config.vision_fovy);
  options.width = static_cast<int>(config.vision_width);
  options.height = static_cast<int>(config.vision_height);
  options.fovy = config.vision_fovy;
  return options;
}

void check_choice(std::int32_t value, std::int32_t low, std::int32_t high, const char* argument) {
  require(value >= low && value <= high, "{} is {}, expected {} to {}", argument, value, low, high);
}

senses::TouchOptions touch(const mimo_agent_config& config) {
  constexpr std::uint32_t kForces = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE;
  check_bits(config.touch, kForces | MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE, "touch");
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

env::AgentOptions agent_options(const mimo_agent_config& config) {
  check_flag(config.vestibular, "vestibular");
  env::AgentOptions options;
  options.name = text(config.name);
  check_agent_name(options.name);
  options.proprioception = proprioception(config);
  options.vestibular = config.vestibular != 0;
  options.vision = vision(config);
  options.touch = touch(config);
  return options;
}

std::size_t add_agent(SceneObject& object, const mimo_agent_config& config) {
  const env::AgentOptions options = agent_options(config);
  for (const env::AgentOptions& other : object.agents) {
    require(other.name != options.name, "name: there is an agent \"{}\" already", options.name);
    require(!other.name.empty() && !options.name.empty(), "name is \"\", but each of several agents needs a name");
  }
  check_flag(config.place_given, "place_given");
  object.agents.reserve(object.agents.size() + 1);
  const std::string body = text(config.body);
  if (body != "scene") {
    const bool placed = config.place_given != 0;
    const scene::Pose place = placed ? pose(config.position, config.orientation) : scene::Pose{};
    object.scene.add_body(body, options.prefix(), placed ? &place : nullptr);
  }
  object.agents.push_back(options);
  return object.agents.size() - 1;
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

// How many of the three sizes each shape has.
int size_count(std::int32_t shape) {
  switch (shape) {
    case MIMO_SHAPE_SPHERE: return 1;
    case MIMO_SHAPE_CAPSULE:
    case MIMO_SHAPE_CYLINDER: return 2;
    case MIMO_SHAPE_ELLIPSOID:
    case MIMO_SHAPE_BOX: return 3;
    default: fail(Status::kInvalidArgument, "shape is {}, expected MIMO_SHAPE_SPHERE (1) to MIMO_SHAPE_BOX (5)", shape);
  }
}

scene::Object object_from(const mimo_object_config& config) {
  scene::Object object;
  object.name = text(config.name);
  require(!object.name.empty(), "name is empty, expected a name for the object");
  const int sizes = size_count(config.shape);
  object.shape = static_cast<scene::Shape>(config.shape);
  for (int i = 0; i < sizes; ++i) {
    require(config.size[i] > 0 && std::isfinite(config.size[i]), "size[{}] is {}, expected metres above 0", i,
            config.size[i]);
    object.size[static_cast<std::size_t>(i)] = config.size[i];
  }
  object.pose = pose(config.position, config.orientation);
  require(config.mass >= 0 && std::isfinite(config.mass), "mass is {}, expected kilograms, or 0", config.mass);
  object.mass = config.mass;
  for (int i = 0; i < 4; ++i) {
    require(config.rgba[i] >= 0 && config.rgba[i] <= 1, "rgba[{}] is {}, expected 0 to 1", i, config.rgba[i]);
    object.rgba[static_cast<std::size_t>(i)] = config.rgba[i];
  }
  check_flag(config.fixed, "fixed");
  object.fixed = config.fixed != 0;
  return object;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_scene_config_init(mimo_scene_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_scene_config(), "config"); });
}

mimo_status mimo_agent_config_init(mimo_agent_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_agent_config(), "config"); });
}

mimo_status mimo_object_config_init(mimo_object_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_object_config(), "config"); });
}

const char* mimo_scene_builtin(size_t index) noexcept { return scene::built_in_scene(index); }

mimo_status mimo_scene_create(const mimo_scene_config* config, mimo_scene** scene) noexcept {
  return guard([&] {
    mimo_scene*& result = out(scene, "scene");
    const mimo_scene_config ours = read_struct(config, default_scene_config(), "config");
    result = wrap<mimo_scene>(std::unique_ptr<SceneObject>(
        new SceneObject{scene::Scene(source(ours)), {}, LogSink{ours.log, ours.log_user}}));
  });
}

void mimo_scene_destroy(mimo_scene* scene) noexcept { destroy(scene); }

mimo_status mimo_scene_add_agent(mimo_scene* scene, const mimo_agent_config* config, int32_t* agent) noexcept {
  return guard([&] {
    SceneObject& object = open(scene);
    const std::size_t index = add_agent(object, read_struct(config, default_agent_config(), "config"));
    if (agent != nullptr) *agent = static_cast<int32_t>(index);
  });
}

mimo_status mimo_scene_set_touch(mimo_scene* scene, int32_t agent, const char* body, double spacing) noexcept {
  return guard([&] { set_touch(open(scene), agent, body, spacing); });
}

mimo_status mimo_scene_add_object(mimo_scene* scene, const mimo_object_config* config) noexcept {
  return guard([&] {
    SceneObject& object = open(scene);
    require(config != nullptr, "config is NULL, but an object needs at least a name");
    object.scene.add_object(object_from(read_struct(config, default_object_config(), "config")));
  });
}

mimo_status mimo_scene_xml(const mimo_scene* scene, char* text, size_t capacity, size_t* length) noexcept {
  return guard([&] {
    const std::string xml = open(scene).scene.xml();
    check_buffer(text, capacity, xml.size() + 1, "text");
    if (text != nullptr) std::copy_n(xml.c_str(), xml.size() + 1, text);
    if (length != nullptr) *length = xml.size();
  });
}

}  // extern "C"
