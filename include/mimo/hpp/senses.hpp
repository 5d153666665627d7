/**
 * @file mimo/hpp/senses.hpp
 * Senses on a simulation of the program's own. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_SENSES
#define MIMO_HPP_SENSES

#include <string>
#include <vector>

#include "layout.hpp"
#include "scene.hpp"

namespace mimo {
inline namespace v1_0 {

namespace detail {
inline void destroy_senses(mimo_senses *senses) { mimo_senses_destroy(senses); }
}  // namespace detail

/// Senses on the program's own MuJoCo model, which outlives them:
///   mimo_senses_config config = mimo::senses_config(mj_version(), sizeof(mjModel), sizeof(mjData));
///   mimo::Senses senses(scene, model, config);
///   senses.reset(data, 1);
///   mj_step(model, data);
///   senses.advance(data);
///   senses.observe(data, block);
class Senses : public Handle<mimo_senses, detail::destroy_senses> {
 public:
  Senses(const Scene &scene, const void *model, const mimo_senses_config &config)
      : Handle(attach(scene, model, config)) {}

  /// What is observed.
  Layout layout() const { return detail::layout_of<mimo_senses>(get(), mimo_senses_layout); }
  Block make_block() const { return layout().make_block(); }

  /// Starts an episode; without a seed its noise goes on from the last one's.
  void reset(const void *data) { check(mimo_senses_reset(get(), data, nullptr)); }
  void reset(const void *data, std::uint64_t seed) {
    const mimo_reset_config config = detail::seeded(seed);
    check(mimo_senses_reset(get(), data, &config));
  }
  /// One step later: what is late takes in what the data hold.
  void advance(const void *data) { check(mimo_senses_advance(get(), data)); }
  /// Dynamic and static drive of both muscles of each motor, Hz: see mimo_senses_drive_spindles. No motors: all.
  void drive_spindles(const std::vector<std::int32_t> &actuators, const std::vector<double> &rates) {
    check(mimo_senses_drive_spindles(get(), actuators.empty() ? nullptr : actuators.data(), actuators.size(),
                                     rates.data(), rates.size()));
  }
  /// Lets a body play samples, Pa at 1 m, from the next advance on; none: what it plays ends.
  void play(const std::string &body, const std::vector<float> &samples, double rate) {
    check(mimo_senses_play(get(), body.c_str(), samples.data(), samples.size(), rate));
  }
  void observe(const void *data, Block &block) { check(mimo_senses_observe(get(), data, block.data(), block.bytes())); }

  /// What the senses remember.
  std::vector<std::uint8_t> save() const {
    std::size_t bytes = 0;
    check(mimo_senses_state_size(get(), &bytes));
    std::vector<std::uint8_t> state(bytes);
    check(mimo_senses_state_save(get(), state.data(), state.size()));
    return state;
  }
  mimo_load_report load(const std::vector<std::uint8_t> &state) {
    mimo_load_report report = detail::described<mimo_load_report>();
    check(mimo_senses_state_load(get(), state.data(), state.size(), &report));
    return report;
  }

 private:
  static mimo_senses *attach(const Scene &scene, const void *model, const mimo_senses_config &config) {
    mimo_senses *senses = nullptr;
    check(mimo_senses_attach(scene.get(), model, &config, &senses));
    return senses;
  }
};

}  // namespace v1_0
}  // namespace mimo

#endif
