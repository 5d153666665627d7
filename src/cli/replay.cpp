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
#include "cli/recorded_world.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

struct ReplayOptions {
  FollowOptions follow;  // with the options that change what is sensed
  RecorderOptions recorder;
  std::string file;
  double from = 0;
  std::optional<double> seconds;
  bool by_joints = false;
  bool json = false;
};

class Replay {
 public:
  Replay(const ReplayOptions& options, const CLI::App& command);
  void play();
  void report() const;

 private:
  void find_end();
  std::size_t seek(std::uint32_t how);

  const ReplayOptions& options_;
  mimo::Recording recording_;
  mimo_recording_info info_;
  mimo::Env env_;
  mimo::Block block_;
  mimo::Results results_;
  std::size_t first_ = 0, start_ = 0, end_ = 0;  // steps: of the state, asked for, behind the last one
};

std::uint64_t seed_of(const std::string& file, std::string_view words) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), seed);
  if (error == std::errc() && end == words.data() + words.size()) return seed;
  throw Failure(file + " is not a complete recording: its attribute 'seed' is not a whole number");
}

Replay::Replay(const ReplayOptions& options, const CLI::App& command)
    : options_(options),
      recording_(options.file),
      info_(recording_.info()),
      env_(open_recorded(options.file, recording_, options.follow.world, command)),
      block_(env_.make_block()),
      results_(env_.make_results()) {
  find_end();
  const bool fields = info_.format_version >= 3 && !senses_changed(command) && !options.by_joints;
  first_ = seek((fields ? MIMO_REPLAY_FIELDS : 0) | (options.by_joints ? MIMO_REPLAY_JOINTS : 0));
}

// Where the model is another one, there is still another way.
std::size_t Replay::seek(std::uint32_t how) {
  try {
    return recording_.seek(env_, start_, how);
  } catch (const mimo::Exception& error) {
    if (error.status() != MIMO_E_MISMATCH || options_.by_joints) throw;
    throw Failure(std::string(error.what()) + ": --by-joints");
  }
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
      recorder.emplace(open_recorder(env_, options_.recorder, seed_of(options_.file, info_.seed)));
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
                                         {"by_joints", options_.by_joints},
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
  CLI::Option* joints = command->add_flag("--by-joints", options->by_joints,
                                          "Set the joints' recorded positions instead of stepping; for recordings of "
                                          "another\nmodel or version, whose states do not "
                                          "fit. Senses with a memory start afresh");
  add_recorder_options(*command, options->recorder);
  CLI::Option* motion = add_follow_options(*command, options->follow);
  for (CLI::Option* other : {file, joints, command->get_option("--from"), command->get_option("--seconds"),
                             command->get_option("--actuation"), command->get_option("--reflexes")}) {
    motion->excludes(other);
  }
  command->add_flag("--json", options->json, "Report in JSON");
  command->footer(
      "The world is that of the recording, which holds all of it; options of senses change what it senses. A "
      "recording\n"
      "of format version 1 or 2 needs --scene, and --age, --actuation and the like as they were. With --out what is "
      "sensed\n"
      "now goes into a new recording, from --from on. Results are the same to the last bit on the same build.\n"
      "A movement is a table with a header: a column time, in seconds, and one for each joint, in radians; of one "
      "that\n"
      "moves freely NAME:x to NAME:qz, where the first infant's is also called root. Poses of bodies, BODY:x to "
      "BODY:qz,\n"
      "are followed by the joints on their way to the world. Between the rows lie natural cubic splines. Or it is a "
      "BVH\n"
      "skeleton, or markers of a C3D, TRC or Qualisys TSV file.\n"
      "Examples:\n"
      "  mimo replay run.h5 --json\n"
      "  mimo replay run.h5 --from 30 --seconds 5 --vision 128 --keep vision --out eyes.h5\n"
      "  mimo replay --motion motion.csv --scene benchmark --forces torques.csv\n"
      "  mimo replay --motion walk.bvh --scene free --joints joints.csv\n"
      "  mimo replay --motion kicks.c3d --scene free --senses all --keep all --out run.h5");
  command->callback([options, command] {
    options->follow.json = options->json;
    if (!options->follow.motion.empty()) return follow(options->follow, options->recorder);
    if (options->file.empty()) throw CLI::RequiredError("FILE.h5 or --motion");
    replay(*options, *command);
  });
}

}  // namespace cli
