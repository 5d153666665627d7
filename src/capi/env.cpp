#include "capi/calls.h"
#include "capi/check.h"
#include "capi/configs.h"
#include "capi/handed.h"
#include "capi/objects.h"
#include "capi/own_sense.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {

mimo_env_config default_env_config() {
  mimo_env_config config{};
  config.struct_size = sizeof config;
  config.jacobian = MIMO_JACOBIAN_MODEL;
  config.renderer = "auto";
  config.render = MIMO_RENDER_SHADOWS | MIMO_RENDER_REFLECTIONS | MIMO_RENDER_SKY | MIMO_RENDER_HAZE;
  config.render_threads = 1;
  return config;
}

namespace {

render::Quality quality(const mimo_env_config& config) {
  constexpr std::uint32_t kKnown =
      MIMO_RENDER_SHADOWS | MIMO_RENDER_REFLECTIONS | MIMO_RENDER_SKY | MIMO_RENDER_HAZE | MIMO_RENDER_FOG;
  check_bits(config.render, kKnown, "render");
  const auto has = [&](std::uint32_t bit) { return (config.render & bit) != 0; };
  render::require_samples(config.samples);
  render::Quality quality;
  quality.shadows = has(MIMO_RENDER_SHADOWS);
  quality.reflections = has(MIMO_RENDER_REFLECTIONS);
  quality.skybox = has(MIMO_RENDER_SKY);
  quality.haze = has(MIMO_RENDER_HAZE);
  quality.fog = has(MIMO_RENDER_FOG);
  quality.samples = static_cast<int>(config.samples);
  quality.threads = static_cast<int>(in_range(config.render_threads, ranges::env_config::render_threads));
  return quality;
}

engine::PhysicsOptions physics(const mimo_env_config& config) {
  check_choice(config.jacobian, MIMO_JACOBIAN_MODEL, MIMO_JACOBIAN_SPARSE, "jacobian");
  check_bits(config.disable, MIMO_DISABLE_CONTACT | MIMO_DISABLE_GRAVITY | MIMO_DISABLE_OWN_SOLVER, "disable");
  engine::PhysicsOptions options;
  options.jacobian = static_cast<engine::Jacobian>(config.jacobian);
  options.contacts = (config.disable & MIMO_DISABLE_CONTACT) == 0;
  options.gravity = (config.disable & MIMO_DISABLE_GRAVITY) == 0;
  options.own_solver = (config.disable & MIMO_DISABLE_OWN_SOLVER) == 0;
  return options;
}

}  // namespace

env::EnvOptions env_options(const mimo_env_config& config) {
  env::EnvOptions options;
  options.frame_skip =
      static_cast<int>(in_range_or_zero(config.frame_skip, ranges::env_config::frame_skip, "", "the scene's own"));
  options.physics = physics(config);
  options.renderer = env::renderer_from(text_or(config.renderer, "auto"));
  options.max_steps = config.max_steps;
  options.task = text(config.task);
  options.quality = quality(config);
  check_flag(config.timing, "timing");
  check_flag(config.step_contacts, "step_contacts");
  options.timing = config.timing != 0;
  options.step_contacts = config.step_contacts != 0;
  return options;
}

blueprint::WorldsByAgePtr worlds_of(const blueprint::Blueprint& blueprint, const mimo_env_config& config,
                                    blueprint::WorldsByAge::DescribedAt described_at) {
  blueprint::SceneEdit edit = blueprint.current();
  note(edit, {{"call", "env_create"}, {"config", json_of(config)}});
  return std::make_shared<blueprint::WorldsByAge>(edit, env_options(config), log_sink(config.log, config.log_user),
                                                  std::move(described_at));
}

EnvObject::EnvObject(blueprint::WorldsByAgePtr worlds, env::CompiledWorldPtr compiled)
    : owned(std::make_unique<blueprint::AgingWorld>(std::move(worlds), std::move(compiled),
                                                    blueprint::Surroundings{identity()})),
      own_layout(capi::own_layout(owned->description())),
      layout(own_layout.get()) {}

EnvObject::EnvObject(const EnvObject& original)
    : owned(std::make_unique<blueprint::AgingWorld>(original.aging(), identity())),
      own_layout(capi::own_layout(owned->description())),
      layout(own_layout.get()) {}

EnvObject::EnvObject(RunningSense& running)
    : own_layout(capi::own_layout(running.before())),
      layout(own_layout.get()),
      sense(&running),
      seen(const_cast<env::World*>(&running.world())) {}

blueprint::AgingWorld& EnvObject::aging() const {
  require_changeable(this);
  return batch == nullptr ? *owned : batch->aging(number);
}

void require_access(const EnvObject& env) {
  if (env.batch != nullptr) env.batch->require_access(env.number);
  if (env.sense == nullptr || env.sense->is_at_work()) return;
  fail(Status::kBusy, "env was lent to a function of a sense, which has returned");
}

namespace {

mimo_env* make_env(const blueprint::Blueprint& blueprint, const mimo_env_config& config) {
  blueprint::WorldsByAgePtr worlds = worlds_of(blueprint, config);
  env::CompiledWorldPtr compiled = worlds->as_described({}, blueprint.log());
  return wrap_env(std::make_unique<EnvObject>(std::move(worlds), std::move(compiled)));
}

}  // namespace

mimo_env* wrap_env(std::unique_ptr<EnvObject> object) {
  EnvObject& inside = *object;
  return inside.handle = wrap<mimo_env>(std::move(object));
}

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_config_init(mimo_env_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_env_config(), "config"); });
}

mimo_status mimo_env_create(const mimo_scene* scene, const mimo_env_config* config, mimo_env** env) noexcept {
  return guard(scene, [&] {
    mimo_env*& result = out(env, "env");
    const blueprint::Blueprint& blueprint = open(scene).blueprint;
    result = make_env(blueprint, read_struct(config, default_env_config(), "config"));
  });
}

mimo_status mimo_env_make(const char* scene_name, mimo_env** env) noexcept {
  return guard([&] {
    mimo_env*& result = out(env, "env");
    require(scene_name != nullptr, "scene_name is NULL");
    require(*scene_name != '\0', "scene_name is \"\", expected the name of a built-in scene");
    blueprint::Blueprint ready = ready_world(scene_name);
    const mimo_agent_config usual = default_agent_config(ready.current().scene);
    ready.edit([&](blueprint::SceneEdit& edit) { note(edit, call_of_agents("add_agents", usual)); });
    result = make_env(ready, default_env_config());
  });
}

mimo_status mimo_env_task(const mimo_env* env, const char** name) noexcept {
  return guard(env, [&] { out(name, "name") = open(env).world().task_name().c_str(); });
}

mimo_status mimo_env_frame_skip(const mimo_env* env, uint32_t* frame_skip) noexcept {
  return guard(env, [&] { out(frame_skip, "frame_skip") = static_cast<uint32_t>(open(env).world().frame_skip()); });
}

mimo_status mimo_env_clone(const mimo_env* env, mimo_env** clone) noexcept {
  return guard(env, [&] {
    mimo_env*& result = out(clone, "clone");
    result = wrap_env(std::make_unique<EnvObject>(open(env)));
  });
}

void mimo_env_destroy(mimo_env* env) noexcept { destroy(env); }

mimo_status mimo_env_layout(const mimo_env* env, const mimo_layout** layout) noexcept {
  return guard(env, [&] { out(layout, "layout") = open(env).layout; });
}

mimo_status mimo_env_agent(const mimo_env* env, size_t index, mimo_agent_info* info) noexcept {
  return guard(env, [&] {
    const auto& agents = open(env).world().agents();
    require(index < agents.size(), "index is {}, but there are {} agents", index, agents.size());
    const env::Agent& agent = agents[index];
    mimo_agent_info ours{};
    ours.action_offset = static_cast<uint32_t>(agent.action_offset);
    ours.action_count = static_cast<uint32_t>(agent.actuation->size());
    ours.name = agent.name.c_str();
    ours.mass = agent.mass;
    ours.height = agent.height;
    write_described(info, ours, "info");
  });
}

}  // extern "C"
