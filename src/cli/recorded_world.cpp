#include "cli/recorded_world.h"

#include <algorithm>
#include <cmath>

#include "programs/program.h"
#include "programs/senses.h"
#include "programs/world.h"

namespace cli {
namespace {

void add_acting_options(CLI::App& command, WorldOptions& options) {
  add_scene_options(command, options);
  add_maturity_options(command, options.age);
  add_actuation_option(command, options);
  add_reflexes_option(command, options);
  add_face_option(command, options);
  add_parameter_option(command, options);
}

// Of an option that a command has.
bool is_given(const CLI::App& command, const std::string& name) { return command.count(name) > 0; }

// The first option that was given of those that say in which world is acted; "" where none was.
std::string given_acting_option(const CLI::App& command) {
  WorldOptions options;
  CLI::App known;
  add_acting_options(known, options);
  for (const CLI::Option* option : known.get_options()) {
    const std::string name = "--" + option->get_single_name();
    if (name != "--help" && is_given(command, name)) return name;
  }
  return "";
}

mimo_agent_config changed_senses(const WorldOptions& options, const CLI::App& command) {
  mimo_agent_config agent = sensing_agent(options);
  const bool sees = is_given(command, "--vision"), all = is_given(command, "--senses");
  if (!sees && is_given(command, "--foveation"))
    throw Failure("--foveation needs --vision, which says how large pictures are");
  const bool feels = all || is_given(command, "--touch");
  for (const Sense& sense : kSenses) {
    const std::string name = sense.name;
    const bool is_changed = name == "vision" ? sees : name == "touch" ? feels : all;
    if (!is_changed) agent.*sense.bits = MIMO_AS_RECORDED;
  }
  return agent;
}

// Steps as long as those of the recording.
mimo::Env open_as_given(const WorldOptions& options, double step_seconds) {
  mimo_env_config config = make_env_config();
  mimo::Env env = open_world(options, config);
  const long long frame_skip = std::llround(step_seconds / env.timestep());
  if (frame_skip == env.frame_skip()) return env;
  config.frame_skip = static_cast<std::uint32_t>(std::clamp(frame_skip, 1LL, 1000LL));
  return open_world(options, config);
}

}  // namespace

CLI::Option* add_recorder_options(CLI::App& command, RecorderOptions& options) {
  command
      .add_option("--keep", options.keep,
                  "Fields to keep: all, none, or a list of senses and names of fields,\nas touch,vision/eye_left")
      ->type_name("LIST")
      ->capture_default_str();
  command.add_option("--state-every", options.state_every, "Simulated time between kept states")
      ->type_name("S")
      ->check(number(mimo::ranges::recorder_config::state_seconds))
      ->capture_default_str();
  command.add_option("--flush-every", options.flush_every, "Real time between writes to the disk")
      ->type_name("S")
      ->check(number(mimo::ranges::recorder_config::flush_seconds))
      ->capture_default_str();
  command.add_option("--compression", options.compression, "0 for none to 9 for the smallest file")
      ->type_name("N")
      ->check(count(mimo::ranges::recorder_config::compression))
      ->capture_default_str();
  command.add_flag("--replace", options.replace, "Replace a complete recording of that name. Default: an error");
  return command.add_option("--out", options.out, "The recording")->type_name("FILE.h5");
}

mimo::Recorder open_recorder(mimo::Env& env, const RecorderOptions& options, std::uint64_t seed) {
  mimo_recorder_config config = mimo::recorder_config();
  if (options.keep != RecorderOptions().keep) config.keep = options.keep.c_str();  // else of whoever has it
  config.state_seconds = options.state_every;
  config.flush_seconds = options.flush_every;
  config.compression = options.compression;
  config.seed = seed;
  config.replace = options.replace ? 1 : 0;
  return mimo::Recorder(env, options.out, config);
}

void add_recorded_options(CLI::App& command, WorldOptions& options) {
  add_acting_options(command, options);
  options.vision = "off";
  add_vision_options(command, options, "off");
  add_foveation_option(command, options);
  add_touch_option(command, options);
  add_senses_option(command, options);
  add_own_senses_option(command, options);
}

bool senses_changed(const CLI::App& command) {
  for (const char* option : {"--vision", "--foveation", "--touch", "--senses"}) {
    if (is_given(command, option)) return true;
  }
  return false;
}

mimo::Env open_recorded(const std::string& file, mimo::Recording& recording, const WorldOptions& options,
                        const CLI::App& command) {
  const mimo_recording_info info = recording.info();
  const std::string given = given_acting_option(command);
  if (info.format_version < 3) {
    if (!is_given(command, "--scene")) {
      throw Failure(file + " has format version " + std::to_string(info.format_version) +
                    ", which contains no scene; pass it with --scene");
    }
    return open_as_given(options, info.step_seconds);
  }
  if (!given.empty()) throw Failure(given + ": " + file + " holds its world itself");
  for (const std::string& library : options.own_senses) recording.load_sense(library);
  mimo_env_config config = make_env_config();
  set_renderer(options, config);
  const mimo_agent_config senses = changed_senses(options, command);
  return recording.env(&config, &senses);
}

}  // namespace cli
