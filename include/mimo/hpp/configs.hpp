/**
 * @file mimo/hpp/configs.hpp
 * Configs with their defaults, and the names that the library knows. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_CONFIGS
#define MIMO_HPP_CONFIGS

#include <string>
#include <vector>

#include "handles.hpp"

namespace mimo {

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
inline mimo_env_config env_config() { return detail::defaults(mimo_env_config_init); }
inline mimo_batch_config batch_config() { return detail::defaults(mimo_batch_config_init); }
inline mimo_picture_config picture_config() { return detail::defaults(mimo_picture_config_init); }
inline mimo_limits limits() { return detail::defaults(mimo_limits_init); }
/// Of a host with that mj_version(), sizeof(mjModel) and sizeof(mjData).
inline mimo_senses_config senses_config(int mujoco_version, std::size_t model_size, std::size_t data_size) {
  mimo_senses_config config = detail::defaults(mimo_senses_config_init);
  config.mujoco_version = mujoco_version;
  config.model_size = model_size;
  config.data_size = data_size;
  return config;
}

/// What the library knows by name.
inline std::vector<std::string> scene_names() { return detail::names(mimo_scene_builtin); }
inline std::vector<std::string> room_names() { return detail::names(mimo_scene_room); }
inline std::vector<std::string> task_names() { return detail::names(mimo_task_name); }
inline std::vector<std::string> face_names() { return detail::names(mimo_face_name); }

}  // namespace mimo

#endif
