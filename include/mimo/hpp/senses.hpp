/**
 * @file mimo/hpp/senses.hpp
 * Senses on a simulation of the program's own. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_SENSES
#define MIMO_HPP_SENSES

#include <string>
#include <vector>

#include "observation.hpp"
#include "scene.hpp"

namespace mimo {

namespace detail {
inline void destroy_senses(mimo_senses *senses) { mimo_senses_destroy(senses); }
}  // namespace detail

/// Senses on the program's own MuJoCo model, which outlives them:
///   mimo::Senses senses(scene, model, mj_version(), sizeof(mjModel), sizeof(mjData));
///   mj_step(model, data);
///   senses.observe(data, block);
class Senses : public Handle<mimo_senses, detail::destroy_senses> {
 public:
  Senses(const Scene &scene, const void *model, int mujoco_version, std::size_t model_size, std::size_t data_size,
         const mimo_env_config &config = env_config())
      : Handle(attach(scene, model, mujoco_version, model_size, data_size, config)) {}

  Block make_block() const { return detail::block_of<mimo_senses>(get(), mimo_senses_observation_size); }
  std::vector<mimo_field> fields() const {
    return detail::fields_of<mimo_senses>(get(), mimo_senses_observation_size, mimo_senses_observation_field);
  }
  /// The field of that name; throws std::out_of_range when there is none.
  mimo_field field(const std::string &name) const { return detail::field_named(fields(), name); }

  void observe(const void *data, Block &block) { check(mimo_senses_observe(get(), data, block.data(), block.bytes())); }

 private:
  static mimo_senses *attach(const Scene &scene, const void *model, int mujoco_version, std::size_t model_size,
                             std::size_t data_size, const mimo_env_config &config) {
    mimo_senses *senses = nullptr;
    check(mimo_senses_attach(scene.get(), &config, model, mujoco_version, model_size, data_size, &senses));
    return senses;
  }
};

}  // namespace mimo

#endif
