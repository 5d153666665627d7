// Senses on a host's own simulation.
#include "capi/check.h"
#include "capi/env.h"
#include "capi/fields.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "engine/host_model.h"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_senses_attach(const mimo_scene* scene, const mimo_env_config* config, const void* model,
                               int32_t mujoco_version, size_t model_size, size_t data_size,
                               mimo_senses** senses) noexcept {
  return guard(scene, [&] {
    mimo_senses*& result = out(senses, "senses");
    const blueprint::Blueprint& blueprint = open(scene).blueprint;
    const mimo_env_config ours = read_struct(config, default_env_config(), "config");
    const env::EnvOptions options = env_options(ours);
    engine::ModelPtr theirs = engine::adopt({model, mujoco_version, model_size, data_size});
    const env::Kit kit = blueprint.around(std::move(theirs), options, log_of(ours));
    result = wrap<mimo_senses>(std::make_unique<SensesObject>(SensesObject{env::Attached(kit)}));
  });
}

void mimo_senses_destroy(mimo_senses* senses) noexcept { destroy(senses); }

mimo_status mimo_senses_observation_size(const mimo_senses* senses, size_t* bytes, size_t* fields) noexcept {
  return guard(senses, [&] { describe_size(open(senses).attached.layout(), bytes, fields); });
}

mimo_status mimo_senses_observation_field(const mimo_senses* senses, size_t index, mimo_field* field) noexcept {
  return guard(senses, [&] { describe_field(open(senses).attached.layout(), index, field); });
}

mimo_status mimo_senses_observation_label(const mimo_senses* senses, size_t index, size_t element,
                                          const char** label) noexcept {
  return guard(senses, [&] { out(label, "label") = label_of(open(senses).attached.layout(), index, element); });
}

mimo_status mimo_senses_touch_sensors(const mimo_senses* senses, size_t agent, int32_t* bodies, int32_t* geoms,
                                      double* positions, double* frames, size_t capacity, size_t* count) noexcept {
  return guard(senses, [&] {
    const auto& agents = open(senses).attached.agents();
    check_agent(agents, agent);
    describe_skin(agents[agent].skin.get(), {bodies, geoms, positions, frames}, capacity, count);
  });
}

mimo_status mimo_senses_observe(mimo_senses* senses, const void* data, void* block, size_t block_bytes) noexcept {
  return guard(senses, [&] {
    env::Attached& attached = open(senses).attached;
    const mjData& theirs = engine::adopt_data(attached.model(), data);
    require(block != nullptr, "block is NULL");
    attached.observe(theirs, block_of(attached.layout(), block, block_bytes));
  });
}

}  // extern "C"
