#include "cli/recorder_options.h"

#include "programs/world.h"

namespace cli {

CLI::Option* add_recorder_options(CLI::App& command, RecorderOptions& options) {
  command
      .add_option("--keep", options.keep,
                  "Fields to keep: all, none, or a list of senses and names of fields,\nas touch,vision/eye_left")
      ->type_name("LIST")
      ->capture_default_str();
  command.add_option("--state-every", options.state_every, "Simulated time between kept states")
      ->type_name("S")
      ->check(number(0.001, 1e6))
      ->capture_default_str();
  command.add_option("--flush-every", options.flush_every, "Real time after which all is safe on disk")
      ->type_name("S")
      ->check(number(0, 1e6))
      ->capture_default_str();
  command.add_option("--compression", options.compression, "0 for none to 9 for the smallest file")
      ->type_name("N")
      ->check(CLI::Range(0, 9).description(""))
      ->capture_default_str();
  command.add_flag("--replace", options.replace, "Replace a whole recording that is there. Default: it is an error");
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

}  // namespace cli
