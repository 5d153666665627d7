#include "capi/access_arguments.h"
#include "capi/check.h"
#include "capi/configs.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {

BatchObject::BatchObject(const blueprint::WorldsByAgePtr& worlds, const batch::CompiledWorlds& compiled,
                         const batch::Options& options)
    : views(options.worlds),
      batch(
          compiled, options, [this](std::size_t world) { return &views.handles[world]; }, worlds),
      layout(own_layout(batch.description())) {
  // The functions of a user's task get their world's handle; they run where making one would come too late.
  for (std::size_t i = 0; compiled[0]->options.custom_task && i < options.worlds; ++i) view(i);
}

Views::~Views() {
  for (mimo_env* handle : handles) {
    if (handle == nullptr) continue;
    await_nobody(handle);
    dispose(handle);
  }
}

mimo_env* BatchObject::view(std::size_t world) {
  const std::lock_guard alone(views.mutex);
  mimo_env*& known = views.handles[world];
  if (known != nullptr) return known;
  known = wrap_env(std::make_unique<EnvObject>(*this, world));
  keep_for_owner(known);
  return known;
}

EnvObject::EnvObject(BatchObject& all, std::size_t which)
    : layout(all.layout.get()), batch(&all.batch), whole(&all), number(which) {}

namespace {

constexpr std::uint32_t kMostThreads = 1u << 12;

mimo_batch_config default_batch_config() {
  mimo_batch_config config{};
  config.struct_size = sizeof config;
  config.worlds = 1;
  return config;
}

batch::Options batch_options(const mimo_batch_config& config) {
  require(config.threads <= kMostThreads, "threads is {}, expected up to {}, or 0 for the machine's", config.threads,
          kMostThreads);
  check_choice(config.autoreset, MIMO_AUTORESET_NONE, MIMO_AUTORESET_SAME_STEP, "autoreset");
  check_flag(config.restart_failed, "restart_failed");
  check_reserved(config.reserved, "reserved");
  batch::Options options;
  options.worlds = in_range(config.worlds, ranges::batch_config::worlds);
  options.threads = config.threads;
  options.autoreset = static_cast<batch::Autoreset>(config.autoreset);
  options.restart_failed = config.restart_failed != 0;
  return options;
}

batch::CompiledWorlds compiled_worlds_of(blueprint::WorldsByAge& worlds, const mimo_batch_config& config,
                                         const LogSink& scene_log) {
  require(config.cohort_count <= config.worlds, "cohort_count is {}, but there are {} worlds", config.cohort_count,
          config.worlds);
  batch::CompiledWorlds compiled;
  for (const std::optional<growth::Growth>& age : ages_from(config.cohort, config.cohort_count, "cohort")) {
    compiled.push_back(worlds.as_described({age}, scene_log));
  }
  if (compiled.empty()) compiled.push_back(worlds.as_described({}, scene_log));
  return compiled;
}

// What worlds are to become; none: they stay.
batch::CompiledWorlds compiled_worlds_of(const BatchObject& object, const mimo_batch_reset_config& config) {
  if (config.growth == nullptr) return {};
  batch::CompiledWorlds compiled(config.worlds);
  const blueprint::Ages ages = ages_from(config.growth, config.worlds, "growth");
  for (std::size_t i = 0; i < ages.size(); ++i) {
    const bool concerned = config.mask == nullptr || config.mask[i] != 0;
    if (concerned && ages[i]) compiled[i] = object.batch.aging(i).with({ages[i]});
  }
  return compiled;
}

template <typename T>
void get(const mimo_batch* batch, std::int32_t quantity, const std::int32_t* ids, std::size_t id_count,
         const std::uint8_t* mask, std::size_t worlds, T* values, std::size_t value_count) {
  const batch::Batch& inner = open(batch).batch;
  const Request wanted = request_from(quantity);
  const access::Ids which = ids_of(inner, wanted.quantity, ids, id_count);
  check_per_world(inner, worlds, mask != nullptr);
  check_values(inner, wanted.quantity, which, values, value_count);
  inner.get(wanted.quantity, which, wanted.now, mask, values);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_batch_config_init(mimo_batch_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_batch_config(), "config"); });
}

mimo_status mimo_batch_create(const mimo_scene* scene, const mimo_env_config* env_config,
                              const mimo_batch_config* batch_config, mimo_batch** batch) noexcept {
  return guard(scene, [&] {
    mimo_batch*& result = out(batch, "batch");
    const mimo_batch_config many = read_struct(batch_config, default_batch_config(), "batch_config");
    const batch::Options options = batch_options(many);
    const blueprint::Blueprint& blueprint = open(scene).blueprint;
    blueprint::WorldsByAgePtr worlds =
        worlds_of(blueprint, read_struct(env_config, default_env_config(), "env_config"));
    const batch::CompiledWorlds compiled = compiled_worlds_of(*worlds, many, blueprint.log());
    auto object = std::make_unique<BatchObject>(worlds, compiled, options);
    BatchObject& inside = *object;
    inside.handle = result = wrap<mimo_batch>(std::move(object));
  });
}

void mimo_batch_destroy(mimo_batch* batch) noexcept { destroy(batch); }

mimo_status mimo_batch_size(const mimo_batch* batch, size_t* worlds, size_t* threads) noexcept {
  return guard_guest(batch, [&] {
    const batch::Batch& inner = open(batch).batch;
    if (worlds != nullptr) *worlds = inner.size();
    if (threads != nullptr) *threads = inner.threads();
  });
}

mimo_status mimo_batch_layout(const mimo_batch* batch, const mimo_layout** layout) noexcept {
  return guard_guest(batch, [&] { out(layout, "layout") = open(batch).layout.get(); });
}

mimo_status mimo_batch_world(mimo_batch* batch, size_t world, mimo_env** env) noexcept {
  return guard_guest(batch, [&] {
    BatchObject& object = open(batch);
    object.batch.require_idle();
    require(world < object.batch.size(), "world is {}, but there are {} worlds", world, object.batch.size());
    out(env, "env") = object.view(world);
  });
}

mimo_status mimo_batch_world_error(const mimo_batch* batch, size_t world, mimo_status* status,
                                   const char** message) noexcept {
  return guard_guest(batch, [&] {
    const batch::Batch& inner = open(batch).batch;
    inner.require_idle();
    require(world < inner.size(), "world is {}, but there are {} worlds", world, inner.size());
    const batch::Report& report = inner.report(world);
    if (status != nullptr) *status = static_cast<mimo_status>(report.status);
    if (message != nullptr) *message = report.message.c_str();
  });
}

mimo_status mimo_batch_reset(mimo_batch* batch, const mimo_batch_reset_config* config, void* blocks,
                             size_t block_bytes) noexcept {
  return guard(batch, [&] {
    BatchObject& object = open(batch);
    batch::Batch& inner = object.batch;
    const mimo_batch_reset_config ours = read_struct(config, mimo_batch_reset_config{}, "config");
    check_reserved(ours.reserved, "config: reserved");
    check_per_world(inner, ours.worlds, ours.seeds != nullptr || ours.mask != nullptr || ours.growth != nullptr);
    std::uint8_t* start = blocks_of(inner, blocks, block_bytes, "blocks");
    inner.require_idle();
    inner.reset(ours.seeds, ours.mask, start, compiled_worlds_of(object, ours));
  });
}

mimo_status mimo_batch_step(mimo_batch* batch, const float* actions, size_t action_count, void* blocks,
                            size_t block_bytes, const mimo_batch_results* results) noexcept {
  return guard(batch, [&] {
    batch::Batch& inner = open(batch).batch;
    inner.step(actions_of(inner, actions, action_count), output_of(inner, blocks, block_bytes, results));
  });
}

mimo_status mimo_batch_send(mimo_batch* batch, const float* actions, size_t action_count, void* blocks,
                            size_t block_bytes, const mimo_batch_results* results) noexcept {
  return guard(batch, [&] {
    batch::Batch& inner = open(batch).batch;
    inner.send(actions_of(inner, actions, action_count), output_of(inner, blocks, block_bytes, results));
  });
}

mimo_status mimo_batch_receive(mimo_batch* batch) noexcept {
  return guard(batch, [&] { open(batch).batch.receive(); });
}

mimo_status mimo_batch_observe(mimo_batch* batch, const uint8_t* mask, size_t worlds, void* blocks,
                               size_t block_bytes) noexcept {
  return guard(batch, [&] {
    batch::Batch& inner = open(batch).batch;
    check_per_world(inner, worlds, mask != nullptr);
    require(blocks != nullptr, "blocks is NULL");
    inner.observe(mask, blocks_of(inner, blocks, block_bytes, "blocks"));
  });
}

mimo_status mimo_batch_get(const mimo_batch* batch, int32_t quantity, const int32_t* ids, size_t id_count,
                           const uint8_t* mask, size_t worlds, double* values, size_t value_count) noexcept {
  return guard(batch, [&] { get(batch, quantity, ids, id_count, mask, worlds, values, value_count); });
}

mimo_status mimo_batch_get_float(const mimo_batch* batch, int32_t quantity, const int32_t* ids, size_t id_count,
                                 const uint8_t* mask, size_t worlds, float* values, size_t value_count) noexcept {
  return guard(batch, [&] { get(batch, quantity, ids, id_count, mask, worlds, values, value_count); });
}

mimo_status mimo_batch_set(mimo_batch* batch, int32_t quantity, const int32_t* ids, size_t id_count,
                           const uint8_t* mask, size_t worlds, const double* values, size_t value_count) noexcept {
  return guard(batch, [&] {
    batch::Batch& inner = open(batch).batch;
    const access::Quantity& what = writable_from(quantity);
    const access::Ids which = ids_of(inner, what, ids, id_count);
    check_per_world(inner, worlds, mask != nullptr);
    check_values(inner, what, which, values, value_count);
    inner.set(what, which, mask, values);
  });
}

mimo_status mimo_batch_state_size(const mimo_batch* batch, size_t* bytes) noexcept {
  return guard(batch, [&] {
    const batch::Batch& inner = open(batch).batch;
    std::size_t& size = out(bytes, "bytes");
    inner.require_idle();
    size = inner.state_bytes();
  });
}

mimo_status mimo_batch_state_save(mimo_batch* batch, const uint8_t* mask, size_t worlds, void* states,
                                  size_t state_bytes) noexcept {
  return guard(batch, [&] {
    batch::Batch& inner = open(batch).batch;
    auto* start = static_cast<std::uint8_t*>(states);
    check_per_world(inner, worlds, mask != nullptr);
    require(start != nullptr, "states is NULL");
    check_buffer(start, state_bytes, inner.size() * inner.state_bytes(), "states");
    inner.save(mask, start);
  });
}

mimo_status mimo_batch_state_load(mimo_batch* batch, const uint8_t* mask, size_t worlds, const void* states,
                                  size_t state_bytes, mimo_load_report* report) noexcept {
  return guard(batch, [&] {
    BatchObject& object = open(batch);
    batch::Batch& inner = object.batch;
    check_per_world(inner, worlds, mask != nullptr);
    require(states != nullptr, "states is NULL");
    const Span<const std::uint8_t> bytes(static_cast<const std::uint8_t*>(states), state_bytes);
    load_and_report(report, object.loaded, [&] { return inner.load(mask, bytes); });
  });
}

}  // extern "C"
