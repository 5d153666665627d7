/**
 * @file mimo/hpp/batch.hpp
 * Batches: many worlds of one scene, stepped by a pool of threads. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_BATCH
#define MIMO_HPP_BATCH

#include <cstdint>
#include <string>
#include <vector>

#include "env.hpp"

namespace mimo {
inline namespace v1_0 {

namespace detail {
inline void destroy_batch(mimo_batch *batch) { mimo_batch_destroy(batch); }
}  // namespace detail

/// Many worlds, stepped by a pool of threads. Arrays stack the worlds along their first axis.
class Batch : public Handle<mimo_batch, detail::destroy_batch> {
 public:
  Batch(const Scene &scene, std::size_t worlds, const mimo_env_config &env = env_config())
      : Batch(scene, env, sized(worlds)) {}
  Batch(const Scene &scene, const mimo_env_config &env, const mimo_batch_config &config)
      : Handle(create(scene, env, config)) {}
  /// Worlds of several ages: all infants of world i become cohort[i % cohort.size()].
  Batch(const Scene &scene, const mimo_env_config &env, mimo_batch_config config,
        const std::vector<mimo_growth> &cohort)
      : Handle(create_cohort(scene, env, config, cohort)) {}

  std::size_t size() const {
    std::size_t worlds = 0;
    check(mimo_batch_size(get(), &worlds, nullptr));
    return worlds;
  }
  /// One world, which stays the batch's: for mimo_env_ functions, between the batch's own calls.
  mimo_env *world(std::size_t index) {
    mimo_env *env = nullptr;
    check(mimo_batch_world(get(), index, &env));
    return env;
  }
  /// The same as an Env, whose end leaves the world to the batch.
  Env env(std::size_t index) { return Env(world(index)); }

  /// What each of the worlds observes, acts with and is rewarded for; may be asked at any time.
  Layout layout() const { return detail::layout_of<mimo_batch>(get(), mimo_batch_layout); }

  /// Observations of all worlds; that of world i starts at i times the size of one.
  Block make_blocks() const { return Block(layout().info().block_bytes * size()); }

  /// One seed for each world; none: they go on with their own random numbers.
  void reset(const std::vector<std::uint64_t> &seeds, Block &blocks) {
    mimo_batch_reset_config config = detail::described<mimo_batch_reset_config>();
    config.seeds = seeds.empty() ? nullptr : seeds.data();
    config.worlds = seeds.size();
    check(mimo_batch_reset(get(), &config, blocks.data(), blocks.bytes()));
  }
  /// As the config says (some of the worlds, for example), with what infants become: a growth for each world, or none.
  void reset(mimo_batch_reset_config config, const std::vector<mimo_growth> &ages, Block &blocks) {
    const std::vector<const mimo_growth *> places = detail::places_of(ages);
    if (!ages.empty()) {
      config.growth = places.data();
      config.worlds = places.size();
    }
    check(mimo_batch_reset(get(), &config, blocks.data(), blocks.bytes()));
  }
  /// One step; worlds x actions, none leave the controls as they are. `results` says where else it goes, or nullptr.
  void step(const std::vector<float> &actions, Block &blocks, const mimo_batch_results *results = nullptr) {
    check(mimo_batch_step(get(), actions.empty() ? nullptr : actions.data(), actions.size(), blocks.data(),
                          blocks.bytes(), results));
  }

  /// What the motors of all infants do by themselves: actions for the next step, worlds x actions. `which` are
  /// MIMO_MOVEMENT_ bits.
  void spontaneous(std::vector<float> &actions, std::uint32_t which = MIMO_MOVEMENT_ALL) const {
    check(mimo_batch_spontaneous(get(), which, actions.data(), actions.size()));
  }

  /// Starts a step and returns at once. Actions, blocks and what the results point to stay as they are, and where they
  /// are, until receive(); nothing else can be asked of the batch meanwhile.
  void send(const std::vector<float> &actions, Block &blocks, const mimo_batch_results *results = nullptr) {
    check(mimo_batch_send(get(), actions.empty() ? nullptr : actions.data(), actions.size(), blocks.data(),
                          blocks.bytes(), results));
  }
  /// Waits for the step that was sent.
  void receive() { check(mimo_batch_receive(get())); }

  /// What became of a world in the last call that concerned it.
  WorldError world_error(std::size_t index) const {
    mimo_status status = MIMO_OK;
    const char *message = nullptr;
    check(mimo_batch_world_error(get(), index, &status, &message));
    return WorldError{status, message};
  }

  /// The senses of the current states. Here and below a mask has one byte a world: 0 leaves that world alone; an empty
  /// one means all.
  void observe(Block &blocks, const std::vector<std::uint8_t> &mask = {}) {
    check(mimo_batch_observe(get(), masked(mask), mask.size(), blocks.data(), blocks.bytes()));
  }
  /// A quantity of some elements in all worlds, world after world; 0 in those that the mask leaves alone. Without ids of
  /// all of its kind.
  std::vector<double> get_values(mimo_quantity quantity, const std::vector<std::int32_t> &ids,
                                 const std::vector<std::uint8_t> &mask = {}) {
    return values_of(quantity, detail::some(ids), ids.size(), mask);
  }
  std::vector<double> get_values(mimo_quantity quantity) { return values_of(quantity, nullptr, 0, {}); }
  /// The same in single precision.
  std::vector<float> get_floats(mimo_quantity quantity, const std::vector<std::int32_t> &ids) {
    std::vector<float> values(width(quantity, detail::some(ids), ids.size()) * size());
    check(mimo_batch_get_float(get(), quantity, detail::some(ids), ids.size(), nullptr, 0, values.data(),
                               values.size()));
    return values;
  }
  void set_values(mimo_quantity quantity, const std::vector<std::int32_t> &ids, const std::vector<double> &values,
                  const std::vector<std::uint8_t> &mask = {}) {
    check(mimo_batch_set(get(), quantity, detail::some(ids), ids.size(), masked(mask), mask.size(), values.data(),
                         values.size()));
  }
  void set_values(mimo_quantity quantity, const std::vector<double> &values) {
    check(mimo_batch_set(get(), quantity, nullptr, 0, nullptr, 0, values.data(), values.size()));
  }

  /// The states of all worlds, one after the other, each in as many bytes as the longest. Loading takes as many, or one
  /// state for all.
  std::vector<std::uint8_t> save() {
    std::size_t bytes = 0;
    check(mimo_batch_state_size(get(), &bytes));
    std::vector<std::uint8_t> states(bytes * size());
    check(mimo_batch_state_save(get(), nullptr, 0, states.data(), states.size()));
    return states;
  }
  /// The report is that of the world where most started fresh.
  mimo_load_report load(const std::vector<std::uint8_t> &states) {
    mimo_load_report report = detail::described<mimo_load_report>();
    check(mimo_batch_state_load(get(), nullptr, 0, states.data(), states.size(), &report));
    return report;
  }

  void set_face(const std::string &name, std::size_t agent = 0) {
    const double face = env(0).find(MIMO_FACE, name);
    set_values(MIMO_AGENT_FACE, {static_cast<std::int32_t>(agent)}, std::vector<double>(size(), face));
  }

 private:
  std::size_t width(mimo_quantity quantity, const std::int32_t *ids, std::size_t count) {
    std::size_t width = 0;
    check(mimo_env_width(world(0), quantity, ids, count, &width));
    return width;
  }
  std::vector<double> values_of(mimo_quantity quantity, const std::int32_t *ids, std::size_t count,
                                const std::vector<std::uint8_t> &mask) {
    std::vector<double> values(width(quantity, ids, count) * size());
    check(mimo_batch_get(get(), quantity, ids, count, masked(mask), mask.size(), values.data(), values.size()));
    return values;
  }
  static const std::uint8_t *masked(const std::vector<std::uint8_t> &mask) {
    return mask.empty() ? nullptr : mask.data();
  }
  static mimo_batch_config sized(std::size_t worlds) {
    mimo_batch_config config = batch_config();
    config.worlds = static_cast<std::uint32_t>(worlds);
    return config;
  }
  static mimo_batch *create(const Scene &scene, const mimo_env_config &env, const mimo_batch_config &config) {
    mimo_batch *batch = nullptr;
    check(mimo_batch_create(scene.get(), &env, &config, &batch));
    return batch;
  }
  static mimo_batch *create_cohort(const Scene &scene, const mimo_env_config &env, mimo_batch_config config,
                                   const std::vector<mimo_growth> &cohort) {
    const std::vector<const mimo_growth *> places = detail::places_of(cohort);
    config.cohort = places.data();
    config.cohort_count = places.size();
    return create(scene, env, config);
  }
};

}  // namespace v1_0
}  // namespace mimo

#endif
