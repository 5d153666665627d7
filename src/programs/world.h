// What most commands share: which world to open, and the options for it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <mimo/mimo.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/ranges.h"

namespace cli {

// How old the infants of a world are.

struct AgeOptions {
  std::optional<double> age, physiological_age;  // months
  std::string sex = "mean";
  std::string growth = "who";
  double percentile = 0;
  double z_length = 0, z_weight = 0, z_head = 0;
  bool eyes = false, delays = false;  // are as old, where an age is given
};

void add_age_options(CLI::App& command, AgeOptions& options);
// Whether eyes and nerves are as old as the infant; by themselves they are.
void add_maturity_options(CLI::App& command, AgeOptions& options);

// What was asked for; nothing where that is nothing.
std::optional<mimo_growth> growth_of(const AgeOptions& options);

struct WorldOptions {
  std::string scene = "benchmark";    // a built-in name or a file
  std::string body;                   // "" means the default of the scene
  std::vector<std::string> settings;  // "NAME=VALUE": numbers of mimo_agent_config
  AgeOptions age;
  std::string renderer = "auto";
  std::uint32_t samples = 0;                    // a pixel; 0: the renderer's own
  std::uint32_t render_threads = 1;             // that draw one picture
  std::string effects;                          // comma-separated, or "none"; "" for the usual ones
  std::uint32_t eye_width = 0, eye_height = 0;  // of an eye's picture that is no square; 0: as vision says
  double foveation = 0;                         // of the eyes' colour pictures; 0: none
  std::string vision;        // "off", pixels, or "" for 256 where a renderer works; with kOwn "" is the scene's
  bool every_sense = false;  // beside those, all that nerves tell: receptors of skin, muscles, joints and labyrinth
  bool hearing = false;      // beside those
  bool voice = false;        // that the infant moves like its motors
  std::string reflexes = "none";  // comma-separated, or "all"
  std::string touch = "1";        // "off", or the scale; with kOwn "" is the scene's
  std::string face;               // "" means the model's own
  std::string actuation;          // "" means the scene's own
  std::uint64_t seed = 0;
  std::vector<std::string> own_senses;  // shared libraries
  std::vector<std::string> parameters;  // "NAME=VALUE": of tasks and of these senses
};

// The parts of a list with commas between.
std::vector<std::string> parts_of(const std::string& list);

// How many steps of so many seconds that is, at least one.
std::size_t steps_in(double seconds, double step);

// Accept finite numbers of a range; CLI::Range takes "nan" for one.
CLI::Validator number(double low, double high);
CLI::Validator number(const mimo::ranges::Range<double>& range);
CLI::Validator count(const mimo::ranges::Range<std::uint32_t>& range);

constexpr char kUsualVision[] = "256, or off where nothing can draw";

// Each adds options to a command; that of vision also adds those of add_renderer_option.
void add_scene_options(CLI::App& command, WorldOptions& options);
void add_vision_options(CLI::App& command, WorldOptions& options, const std::string& usual = kUsualVision);
void add_foveation_option(CLI::App& command, WorldOptions& options);
void add_touch_option(CLI::App& command, WorldOptions& options);
void add_renderer_option(CLI::App& command, WorldOptions& options);  // and those for how pictures are made
void add_actuation_option(CLI::App& command, WorldOptions& options);
void add_voice_option(CLI::App& command, WorldOptions& options);
void add_senses_option(CLI::App& command, WorldOptions& options);
void add_reflexes_option(CLI::App& command, WorldOptions& options);
void add_face_option(CLI::App& command, WorldOptions& options);
// Senses of the user's own. No option that a file can hold: a file must not have code loaded.
void add_own_senses_option(CLI::App& command, WorldOptions& options);
void add_parameter_option(CLI::App& command, WorldOptions& options);
void add_seed_option(CLI::App& command, WorldOptions& options);
void add_seconds_option(CLI::App& command, double& seconds);  // how long a world moves

enum class Senses { kAll, kAllButVision, kNone, kOwn };  // kOwn: the scene's defaults

// The config of an infant that senses as the options say.
mimo_agent_config sensing_agent(const WorldOptions& options);

// The scene as its document has it.
mimo::Scene load_scene(const WorldOptions& options);

// The scene with its infants; with one agent where there are none.
mimo::Scene make_scene(const WorldOptions& options, Senses senses);

// An env_config with defaults and the log on stderr.
mimo_env_config make_env_config();

// What draws pictures, and how. The config refers to the options.
void set_renderer(const WorldOptions& options, mimo_env_config& config);

// A world with all its senses. Where eyes were not asked for by name and nothing can draw their pictures here, it
// says so on stderr and has no eyes.
mimo::Env open_world(const WorldOptions& options, mimo_env_config config);

// The world that mimo_env_make gives, with what the options change of it.
mimo::Env open_own_world(const WorldOptions& options, mimo_env_config config);

// A world that senses nothing and needs no renderer: bare physics.
mimo::Env open_bare_world(const WorldOptions& options, mimo_env_config config);

}  // namespace cli
