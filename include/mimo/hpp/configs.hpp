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

/// Configs with their defaults.
inline mimo_scene_config scene_config() {
  mimo_scene_config config;
  check(mimo_scene_config_init(&config, sizeof config));
  return config;
}
inline mimo_agent_config agent_config() {
  mimo_agent_config config;
  check(mimo_agent_config_init(&config, sizeof config));
  return config;
}
inline mimo_object_config object_config() {
  mimo_object_config config;
  check(mimo_object_config_init(&config, sizeof config));
  return config;
}
inline mimo_env_config env_config() {
  mimo_env_config config;
  check(mimo_env_config_init(&config, sizeof config));
  return config;
}
inline mimo_picture_config picture_config() {
  mimo_picture_config config;
  check(mimo_picture_config_init(&config, sizeof config));
  return config;
}

inline mimo_model_config model_config() {
  mimo_model_config config;
  check(mimo_model_config_init(&config, sizeof config));
  return config;
}

inline mimo_camera_config camera_config() {
  mimo_camera_config config;
  check(mimo_camera_config_init(&config, sizeof config));
  return config;
}

inline mimo_limits limits() {
  mimo_limits limits;
  check(mimo_limits_init(&limits, sizeof limits));
  return limits;
}

}  // namespace mimo

#endif
