/**
 * @file mimo/hpp/configs.hpp
 * Configs with their defaults, and what the library knows: names, parameters of tasks, its versions. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_CONFIGS
#define MIMO_HPP_CONFIGS

#include <cstdint>
#include <string>
#include <vector>

#include "handles.hpp"

namespace mimo {
inline namespace v1_0 {

namespace detail {
template <typename Config>
Config defaults(mimo_status (*init)(Config *, std::size_t)) {
  Config config;
  check(init(&config, sizeof config));
  return config;
}
/// A struct that a call fills.
template <typename Description>
Description described() {
  Description description{};
  description.struct_size = sizeof description;
  return description;
}

/// An episode whose random numbers start anew from a seed.
inline mimo_reset_config seeded(std::uint64_t seed) {
  mimo_reset_config config = described<mimo_reset_config>();
  config.seeded = 1;
  config.seed = seed;
  return config;
}
/// Pointers to the elements, as the library takes growths.
inline std::vector<const mimo_growth *> places_of(const std::vector<mimo_growth> &growths) {
  std::vector<const mimo_growth *> places;
  for (const mimo_growth &growth : growths) places.push_back(&growth);
  return places;
}
inline std::vector<std::string> names(const char *(*name)(std::size_t)) {
  std::vector<std::string> all;
  for (std::size_t i = 0; name(i) != nullptr; ++i) all.push_back(name(i));
  return all;
}
}  // namespace detail

/// Configs with their defaults.
inline mimo_scene_config scene_config() { return detail::defaults(mimo_scene_config_init); }
inline mimo_agent_config agent_config() { return detail::defaults(mimo_agent_config_init); }
inline mimo_object_config object_config() { return detail::defaults(mimo_object_config_init); }
inline mimo_model_config model_config() { return detail::defaults(mimo_model_config_init); }
inline mimo_camera_config camera_config() { return detail::defaults(mimo_camera_config_init); }
inline mimo_field_config field_config() { return detail::defaults(mimo_field_config_init); }
inline mimo_env_config env_config() { return detail::defaults(mimo_env_config_init); }
inline mimo_batch_config batch_config() { return detail::defaults(mimo_batch_config_init); }
inline mimo_picture_config picture_config() { return detail::defaults(mimo_picture_config_init); }
inline mimo_limits limits() { return detail::defaults(mimo_limits_init); }
/// The body of 18 months.
inline mimo_growth growth() { return detail::defaults(mimo_growth_init); }
/// Perfect eyes, and nerves that take no time.
inline mimo_maturity maturity() { return detail::defaults(mimo_maturity_init); }
/// Eyes and nerves of an age, months from 0 to 24.
inline mimo_maturity maturity(double age) {
  mimo_maturity maturity;
  check(mimo_maturity_at(age, &maturity, sizeof maturity));
  return maturity;
}
/// An episode that goes on with the world's random numbers; in a batch one of all worlds.
inline mimo_reset_config reset_config() { return detail::described<mimo_reset_config>(); }
inline mimo_batch_reset_config batch_reset_config() { return detail::described<mimo_batch_reset_config>(); }
/// Of a host with that mj_version(), sizeof(mjModel) and sizeof(mjData).
inline mimo_senses_config senses_config(int mujoco_version, std::size_t model_size, std::size_t data_size) {
  mimo_senses_config config = detail::defaults(mimo_senses_config_init);
  config.mujoco_version = mujoco_version;
  config.model_size = model_size;
  config.data_size = data_size;
  return config;
}

/// What the library knows by name.
inline std::vector<std::string> scene_names() { return detail::names(mimo_scene_name); }
inline std::vector<std::string> room_names() { return detail::names(mimo_room_name); }
inline std::vector<std::string> task_names() { return detail::names(mimo_task_name); }
inline std::vector<std::string> material_names() { return detail::names(mimo_material_name); }
inline std::vector<std::string> face_names() { return detail::names(mimo_face_name); }

/// All by which tasks can be changed: Scene::set_parameter.
inline std::vector<mimo_parameter> parameters() {
  std::size_t count = 0;
  check(mimo_parameter_count(&count));
  std::vector<mimo_parameter> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    all[i].struct_size = sizeof(mimo_parameter);
    check(mimo_parameter_describe(i, &all[i]));
  }
  return all;
}

/// Versions of the library that is loaded, and of the MuJoCo that it runs on.
inline std::string version() { return mimo_version(); }
inline std::string mujoco_version() { return mimo_mujoco_version(); }
/// Whether the library that is loaded knows a function, a constant, a struct or a member of one: "mimo_field.offset".
inline bool supports(const std::string &name) { return mimo_supports(name.c_str()) != 0; }
/// MIMO_API_VERSION of that library.
inline std::uint32_t api_version() { return mimo_api_version(); }
/// Other than MIMO_ABI_VERSION if the program was built with headers that do not belong to the library.
inline std::uint32_t abi_version() { return mimo_abi_version(); }

}  // namespace v1_0
}  // namespace mimo

#endif
