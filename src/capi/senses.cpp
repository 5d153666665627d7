// Senses on a host's own simulation.
#include <cmath>

#include "capi/check.h"
#include "capi/handed.h"
#include "capi/objects.h"
#include "capi/results.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "engine/data.h"

namespace mimo::capi {
namespace {

mimo_senses_config default_senses_config() {
  const mimo_env_config worlds = default_env_config();
  mimo_senses_config config{};
  config.struct_size = sizeof config;
  config.renderer = worlds.renderer;
  config.render = worlds.render;
  config.render_threads = worlds.render_threads;
  return config;
}

// Pictures are drawn as those of worlds.
env::EnvOptions picture_options(const mimo_senses_config& config) {
  mimo_env_config worlds = default_env_config();
  worlds.renderer = config.renderer;
  worlds.render = config.render;
  worlds.samples = config.samples;
  worlds.render_threads = config.render_threads;
  return env_options(worlds);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_senses_config_init(mimo_senses_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_senses_config(), "config"); });
}

mimo_status mimo_senses_attach(const mimo_scene* scene, const void* model, const mimo_senses_config* config,
                               mimo_senses** senses) noexcept {
  return guard(scene, [&] {
    mimo_senses*& result = out(senses, "senses");
    const blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(config != nullptr, "config is NULL, expected one with the host's mujoco_version");
    const mimo_senses_config ours = read_struct(config, "config");
    check_reserved(ours.reserved, "reserved");
    require(ours.step >= 0 && std::isfinite(ours.step), "step is {}, expected seconds above 0, or 0 for the model's",
            ours.step);
    const env::EnvOptions options = picture_options(ours);
    engine::ModelPtr theirs = engine::adopt({model, ours.mujoco_version, ours.model_size, ours.data_size});
    const env::CompiledWorld compiled =
        around(blueprint.current(), std::move(theirs), options, log_sink(ours.log, ours.log_user));
    result = wrap<mimo_senses>(std::make_unique<SensesObject>(compiled, ours.step));
  });
}

void mimo_senses_destroy(mimo_senses* senses) noexcept { destroy(senses); }

mimo_status mimo_senses_layout(const mimo_senses* senses, const mimo_layout** layout) noexcept {
  return guard(senses, [&] { out(layout, "layout") = open(senses).layout.get(); });
}

mimo_status mimo_senses_observe(mimo_senses* senses, const void* data, void* block, size_t block_bytes) noexcept {
  return guard(senses, [&] {
    env::Attached& attached = open(senses).attached;
    const mjData& theirs = engine::adopt_data(attached.model(), data);
    require(block != nullptr, "block is NULL");
    attached.observe(theirs, block_of(attached.layout(), block, block_bytes));
  });
}

mimo_status mimo_senses_reset(mimo_senses* senses, const void* data, const mimo_reset_config* config) noexcept {
  return guard(senses, [&] {
    env::Attached& attached = open(senses).attached;
    const mimo_reset_config ours = read_struct(config, mimo_reset_config{}, "config");
    const Seed seed = seed_of(ours);
    if (ours.growth_count > 0)
      fail(Status::kUnsupported, "growth: attached senses use the host's model, which does not change");
    attached.reset(engine::adopt_data(attached.model(), data), seed.pointer());
  });
}

mimo_status mimo_senses_advance(mimo_senses* senses, const void* data) noexcept {
  return guard(senses, [&] {
    env::Attached& attached = open(senses).attached;
    attached.advance(engine::adopt_data(attached.model(), data));
  });
}

mimo_status mimo_senses_drive_spindles(mimo_senses* senses, const int32_t* actuators, size_t actuator_count,
                                       const double* rates, size_t rate_count) noexcept {
  return guard(senses, [&] {
    env::Attached& attached = open(senses).attached;
    const auto motors = array(actuators, actuator_count, "actuators");
    const auto from = array(rates, rate_count, "rates");
    if (actuators == nullptr) return attached.drive_spindles(attached.driven(), from);
    attached.drive_spindles(motors, from);
  });
}

mimo_status mimo_senses_state_size(const mimo_senses* senses, size_t* bytes) noexcept {
  return guard(senses, [&] { out(bytes, "bytes") = open(senses).attached.state_bytes(); });
}

mimo_status mimo_senses_state_save(const mimo_senses* senses, void* state, size_t state_bytes) noexcept {
  return guard(senses, [&] {
    const env::Attached& attached = open(senses).attached;
    auto* start = static_cast<std::uint8_t*>(state);
    require(start != nullptr, "state is NULL");
    check_buffer(start, state_bytes, attached.state_bytes(), "state");
    attached.save({start, attached.state_bytes()});
  });
}

mimo_status mimo_senses_state_load(mimo_senses* senses, const void* state, size_t state_bytes,
                                   mimo_load_report* report) noexcept {
  return guard(senses, [&] {
    SensesObject& object = open(senses);
    const auto* start = static_cast<const std::uint8_t*>(state);
    require(start != nullptr, "state is NULL");
    load_and_report(report, object.loaded, [&] { return object.attached.load({start, state_bytes}); });
  });
}

}  // extern "C"
