// What most commands share: which world to open, and the options for it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "api.h"

namespace cli {

struct WorldOptions {
  std::string scene = "benchmark";  // a built-in name or a file
  std::string body;                 // "" means the default of the scene
  std::string renderer = "auto";
  std::string vision;       // "off", pixels, or "" for 256 where a renderer works
  std::string touch = "1";  // "off", or the scale
  std::string face;         // "" means the model's own
  std::uint64_t seed = 0;
};

// Each adds options to a command.
void add_scene_options(CLI::App& command, WorldOptions& options);
void add_vision_options(CLI::App& command, WorldOptions& options);  // with add_renderer_option
void add_touch_option(CLI::App& command, WorldOptions& options);
void add_renderer_option(CLI::App& command, WorldOptions& options);
void add_face_option(CLI::App& command, WorldOptions& options);
void add_seed_option(CLI::App& command, WorldOptions& options);

// The infant's body: "mitten", or "scene" where it is part of the scene's file, or "" where there is none: then
// everything in the file is one agent.
std::string body_of_scene(const WorldOptions& options);

enum class Senses { kAll, kAllButVision, kNone };

// The scene with its infants; with one agent where there are none.
Scene make_scene(const WorldOptions& options, Senses senses);

// An env_config with defaults and the log on stderr.
mimo_env_config make_env_config();

// A world with all its senses. Where eyes were not asked for by name and nothing can draw their pictures here, it
// says so on stderr and has no eyes.
Env open_world(const WorldOptions& options, mimo_env_config config);

// A world that senses nothing and needs no renderer: bare physics.
Env open_bare_world(const WorldOptions& options, mimo_env_config config);

}  // namespace cli
