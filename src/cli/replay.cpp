// mimo replay: plays a recording again and says how far the results are from the recorded ones.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "cli/commands.h"
#include "cli/follow.h"
#include "cli/interrupt.h"
#include "cli/recorded_world.h"
#include "cli/recorder_options.h"
#include "programs/failure.h"
#include "programs/files.h"
#include "programs/progress.h"
#include "programs/text.h"

namespace cli {
namespace {

struct ReplayOptions {
  FollowOptions follow;  // with the options that change what is sensed
  RecorderOptions recorder;
  std::string file;
  double from = 0;
  std::optional<double> seconds;
  bool json = false;
};

class Replay {
 public:
  Replay(const ReplayOptions& options, const CLI::App& command);
  void play();
  void report() const;

 private:
  void find_end();

  const ReplayOptions& options_;
  mimo::Recording recording_;
  mimo_recording_info info_;
  std::string configuration_;
  mimo::Env env_;
  mimo::Block block_;
  mimo::Results results_;
  std::size_t first_ = 0, start_ = 0, end_ = 0;  // steps: of the state, asked for, behind the last one
};

// Steps as long as those of the recording.
mimo::Env open_recorded(const WorldOptions& options, const mimo_recording_info& info) {
  mimo_env_config config = make_env_config();
  mimo::Env env = open_world(options, config);
  const long long frame_skip = std::llround(info.step_seconds / env.timestep());
  if (frame_skip == env.frame_skip()) return env;
  config.frame_skip = static_cast<std::int32_t>(std::clamp(frame_skip, 1LL, 1000LL));
  return open_world(options, config);
}

std::uint64_t seed_of(const std::string& file, std::string_view words) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), seed);
  if (error == std::errc() && end == words.data() + words.size()) return seed;
  throw Failure(file + " is not a whole recording: its attribute 'seed' is not a whole number");
}

Replay::Replay(const ReplayOptions& options, const CLI::App& command)
    : options_(options),
      recording_(options.file),
      info_(recording_.info()),
      configuration_(changed_configuration(options.file, info_.configuration, command)),
      env_(open_recorded(read_configuration(options.file, configuration_), info_)),
      block_(env_.make_block()),
      results_(env_.make_results()) {
  find_end();
  first_ = recording_.seek(env_, start_, is_ours(info_.configuration) && !senses_changed(command));
}

void Replay::find_end() {
  const auto steps = [&](double seconds) {
    return static_cast<std::size_t>(std::llround(seconds / info_.step_seconds));
  };
  start_ = steps(options_.from);
  end_ = info_.steps;
  if (start_ > end_) {
    throw Failure(text("--from %g: %s ends at %g s", options_.from, options_.file.c_str(),
                       info_.step_seconds * static_cast<double>(end_)));
  }
  if (options_.seconds) end_ = std::min(end_, start_ + steps(*options_.seconds));
}

void Replay::play() {
  std::optional<mimo::Recorder> recorder;
  const Interrupt interrupt;
  Progress progress(end_ - first_);
  for (std::size_t step = first_; step < end_ && !Interrupt::requested(); ++step) {
    if (step == start_ && !options_.recorder.out.empty()) {
      recorder.emplace(open_recorder(env_, options_.recorder, configuration_, seed_of(options_.file, info_.seed)));
    }
    recording_.step(env_, block_, results_);
    progress.show(step + 1 - first_);
  }
  if (recorder) recorder->close();
}

void Replay::report() const {
  const mimo_replay_report verdict = recording_.report();
  const auto seconds = [&](std::size_t step) { return info_.step_seconds * static_cast<double>(step); };
  if (options_.json) {
    const nlohmann::ordered_json json = {{"identical", verdict.identical != 0},
                                         {"largest_difference", verdict.largest_difference},
                                         {"differs_most_in", verdict.differs_most_in},
                                         {"steps", verdict.steps},
                                         {"from_seconds", seconds(first_)},
                                         {"to_seconds", seconds(verdict.next)},
                                         {"same_build", info_.same_build != 0},
                                         {"recorded_build", info_.build},
                                         {"build", info_.this_build}};
    std::cout << json.dump(2) << "\n";
    return;
  }
  if (info_.same_build == 0)
    std::cout << "recorded with " << info_.build << ", played with " << info_.this_build << "\n";
  std::cout << text("%zu steps from %g s: ", verdict.steps, seconds(first_));
  if (verdict.identical != 0) {
    std::cout << "identical\n";
  } else {
    std::cout << text("not identical, from %g s on; largest difference %g, in %s\n",
                      seconds(verdict.first_difference + 1), verdict.largest_difference, verdict.differs_most_in);
  }
}

void replay(const ReplayOptions& options, const CLI::App& command) {
  if (!options.recorder.out.empty()) {
    require_writable(options.recorder.out);
    std::error_code missing;
    if (std::filesystem::equivalent(options.recorder.out, options.file, missing)) {
      throw Failure("--out is the recording itself");
    }
  }
  Replay replay(options, command);
  replay.play();
  replay.report();
  std::cout.flush();
  if (Interrupt::requested()) Interrupt::pass_on();
}

}  // namespace

void add_replay(CLI::App& program) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = program.add_subcommand("replay", "Play a recording again, and compare");
  CLI::Option* file = command->add_option("file", options->file, "The recording")->type_name("FILE.h5");
  command->add_option("--from", options->from, "Where to start: at the last kept state that is not later")
      ->type_name("S")
      ->check(number(0, 1e9))
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "How much to play from there. Default: all")
      ->type_name("S")
      ->check(number(0, 1e9));
  add_recorded_options(*command, options->follow.world);
  CLI::Option* out = add_recorder_options(*command, options->recorder);
  CLI::Option* motion = add_follow_options(*command, options->follow);
  for (CLI::Option* other : {file, out, command->get_option("--from"), command->get_option("--seconds"),
                             command->get_option("--actuation"), command->get_option("--reflexes")}) {
    motion->excludes(other);
  }
  command->add_flag("--json", options->json, "Report in JSON");
  command->footer(
      "The world is that of the recording; options of senses change what it senses. A recording that another program\n"
      "made needs --scene, and --age, --actuation and the like as that program had them. With --out what is sensed now "
      "goes\n"
      "into a new recording, from --from on. Results are the same to the last bit on the same build.\n"
      "Examples:\n"
      "  mimo replay run.h5 --json\n"
      "  mimo replay run.h5 --from 30 --seconds 5 --vision 128 --keep vision --out eyes.h5\n"
      "  mimo replay --motion motion.csv --scene benchmark --forces torques.csv\n"
      "  mimo replay --motion walk.bvh --scene free --joints joints.csv");
  command->callback([options, command] {
    options->follow.json = options->json;
    if (!options->follow.motion.empty()) return follow(options->follow);
    if (options->file.empty()) throw CLI::RequiredError("FILE.h5 or --motion");
    replay(*options, *command);
  });
}

}  // namespace cli
