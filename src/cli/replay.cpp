// mimo replay: plays a recording again and says how far the results are from the recorded ones.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.h"
#include "failure.h"
#include "files.h"
#include "follow.h"
#include "interrupt.h"
#include "progress.h"
#include "recorded_world.h"
#include "recorder_options.h"
#include "text.h"

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

template <typename T>
double largest_difference(const std::uint8_t* a, const std::uint8_t* b, std::size_t bytes) {
  double largest = 0;
  for (std::size_t at = 0; at < bytes; at += sizeof(T)) {
    T one, other;
    std::memcpy(&one, a + at, sizeof one);
    std::memcpy(&other, b + at, sizeof other);
    const double difference = std::abs(static_cast<double>(one) - static_cast<double>(other));
    const bool same = std::memcmp(&one, &other, sizeof one) == 0;
    if (!same) largest = std::max(largest, std::isfinite(difference) ? difference : std::numeric_limits<double>::max());
  }
  return largest;
}

double largest_difference(std::int32_t dtype, const std::uint8_t* a, const std::uint8_t* b, std::size_t bytes) {
  switch (dtype) {
    case MIMO_U8: return largest_difference<std::uint8_t>(a, b, bytes);
    case MIMO_I32: return largest_difference<std::int32_t>(a, b, bytes);
    case MIMO_F32: return largest_difference<float>(a, b, bytes);
    default: return largest_difference<double>(a, b, bytes);
  }
}

// Of all that was compared so far.
struct Verdict {
  bool identical = true;
  double largest = 0;
  std::string table;      // where that is, "" where all is identical
  std::size_t first = 0;  // the first step that differed
};

class Replay {
 public:
  Replay(const ReplayOptions& options, const CLI::App& command);
  void play();
  void report() const;

 private:
  void require_same_joints() const;
  void seek();
  void compare(std::size_t row);
  void compare(const std::string& table, std::size_t row, std::int32_t dtype, const void* now, std::size_t bytes);

  const ReplayOptions& options_;
  RecordingReader file_;
  std::string configuration_;
  bool changed_;
  WorldOptions world_;
  mimo::Env env_;
  mimo::Block block_;
  mimo::Results results_;
  std::vector<std::int32_t> joints_;
  double dt_;
  std::size_t first_ = 0, start_ = 0, end_ = 0;  // steps: of the state, asked for, behind the last one
  std::size_t played_ = 0;
  Verdict verdict_;
};

Replay::Replay(const ReplayOptions& options, const CLI::App& command)
    : options_(options),
      file_(options.file),
      configuration_(changed_configuration(options.file, file_.text("configuration"), command)),
      changed_(senses_changed(command)),
      world_(read_configuration(options.file, configuration_)),
      env_(open_world(world_, make_env_config())),
      block_(env_.make_block()),
      results_(env_.make_results()),
      joints_(env_.ids(MIMO_JOINT)),
      dt_(env_.timestep() * env_.frame_skip()) {
  require_same_joints();
  seek();
}

void Replay::require_same_joints() const {
  if (file_.text("joint_names") != joint_names(env_)) {
    throw Failure(options_.file + " was recorded with other joints than those of scene " + world_.scene);
  }
}

// To the last kept state that is not behind the time asked for.
void Replay::seek() {
  // A run that was killed may have lost more of one table than of another.
  end_ = std::min({file_.rows(kTime), file_.rows(kJointPosition), file_.rows(kJointVelocity)});
  const std::size_t actions = env_.layout().actions().size();
  if (actions != 0) end_ = std::min(end_, file_.rows(kActions));
  const double length = dt_ * static_cast<double>(end_);
  start_ = static_cast<std::size_t>(std::llround(options_.from / dt_));
  if (start_ > end_) throw Failure(text("--from %g: %s ends at %g s", options_.from, options_.file.c_str(), length));
  if (options_.seconds) end_ = std::min(end_, start_ + static_cast<std::size_t>(std::llround(*options_.seconds / dt_)));
  const std::size_t kept = std::min(file_.rows(kStateSteps), file_.rows(kStates));
  std::optional<std::size_t> state;
  for (std::size_t i = 0; i < kept; ++i) {
    std::int64_t step = 0;
    const auto bytes = file_.row(kStateSteps, i);
    if (bytes.size() != sizeof step)
      throw Failure(options_.file + " is not a whole recording: 'states/step' is not of 64 bits");
    std::memcpy(&step, bytes.data(), sizeof step);
    if (step < 0 || static_cast<std::size_t>(step) > start_) break;
    state = i;
    first_ = static_cast<std::size_t>(step);
  }
  if (!state) throw Failure(options_.file + " has no state to start from: it was cut off before its first flush");
  mimo::Block sensed = env_.make_block();
  env_.reset(0, sensed);  // senses of other sizes begin fresh
  env_.load(file_.row(kStates, *state));
}

void Replay::compare(const std::string& table, std::size_t row, std::int32_t dtype, const void* now,
                     std::size_t bytes) {
  if (bytes == 0 || !file_.has(table) || row >= file_.rows(table)) return;
  const auto then = file_.row(table, row);
  if (then.size() != bytes) throw Failure(options_.file + " has rows of another length in '" + table + "'");
  if (std::memcmp(then.data(), now, bytes) == 0) return;
  if (verdict_.identical) verdict_.first = row;
  verdict_.identical = false;
  const double difference = largest_difference(dtype, then.data(), static_cast<const std::uint8_t*>(now), bytes);
  if (difference < verdict_.largest) return;
  verdict_.largest = difference;
  verdict_.table = table;
}

void Replay::compare(std::size_t row) {
  const auto bytes = [](const std::vector<double>& values) { return values.size() * sizeof(double); };
  const auto position = env_.get_values(MIMO_JOINT_POSITION, joints_);
  const auto velocity = env_.get_values(MIMO_JOINT_VELOCITY, joints_);
  compare(kJointPosition, row, MIMO_F64, position.data(), bytes(position));
  compare(kJointVelocity, row, MIMO_F64, velocity.data(), bytes(velocity));
  compare(kRewards, row, MIMO_F64, results_.reward.data(), bytes(results_.reward));
  if (changed_) return;  // what is sensed otherwise is another number
  for (const mimo_field& field : env_.layout().fields()) {
    compare(field_table(field), row, static_cast<std::int32_t>(field.dtype), block_.data() + field.offset, field.bytes);
  }
}

void Replay::play() {
  std::optional<Recorder> recorder;
  std::vector<float> action(env_.layout().actions().size());
  if (!action.empty() && file_.row_bytes(kActions) != action.size() * sizeof(float)) {
    throw Failure(options_.file + " was recorded with another number of actions");
  }
  const Interrupt interrupt;
  Progress progress(end_ - first_);
  for (std::size_t step = first_; step < end_ && !Interrupt::requested(); ++step) {
    if (!action.empty()) std::memcpy(action.data(), file_.row(kActions, step).data(), action.size() * sizeof(float));
    if (step == start_ && !options_.recorder.out.empty()) {
      recorder.emplace(options_.recorder, env_, configuration_, std::stoull(file_.text("seed")));
    }
    if (recorder) recorder->before_step(env_);
    env_.step(action, block_, results_);
    if (recorder) recorder->after_step(env_, action, block_, results_);
    compare(step);
    progress.show(++played_);
  }
  if (recorder) recorder->finish(env_);
}

void Replay::report() const {
  const std::string recorded = file_.text("build"), here = build_name();
  if (options_.json) {
    const nlohmann::ordered_json json = {{"identical", verdict_.identical},
                                         {"largest_difference", verdict_.largest},
                                         {"differs_most_in", verdict_.table},
                                         {"steps", played_},
                                         {"from_seconds", dt_ * static_cast<double>(first_)},
                                         {"to_seconds", dt_ * static_cast<double>(first_ + played_)},
                                         {"same_build", recorded == here},
                                         {"recorded_build", recorded},
                                         {"build", here}};
    std::cout << json.dump(2) << "\n";
    return;
  }
  if (recorded != here) std::cout << "recorded with " << recorded << ", played with " << here << "\n";
  std::cout << text("%zu steps from %g s: ", played_, dt_ * static_cast<double>(first_));
  if (verdict_.identical) {
    std::cout << "identical\n";
  } else {
    std::cout << text("not identical, from %g s on; largest difference %g, in %s\n",
                      dt_ * static_cast<double>(verdict_.first + 1), verdict_.largest, verdict_.table.c_str());
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
  options->follow.world.vision = "off";
  add_sense_options(*command, options->follow.world);
  CLI::Option* out = add_recorder_options(*command, options->recorder);
  CLI::Option* motion = add_follow_options(*command, options->follow);
  for (CLI::Option* other : {file, out, command->get_option("--from"), command->get_option("--seconds")}) {
    motion->excludes(other);
  }
  command->add_flag("--json", options->json, "Report in JSON");
  command->footer(
      "The world is that of the recording; options of senses change what it senses. With --out what is sensed now "
      "goes\n"
      "into a new recording, from --from on. Results are the same to the last bit on the same build.\n"
      "Examples:\n"
      "  mimo replay run.h5 --json\n"
      "  mimo replay run.h5 --from 30 --seconds 5 --vision 128 --keep vision --out eyes.h5\n"
      "  mimo replay --motion motion.csv --scene benchmark --forces torques.csv");
  command->callback([options, command] {
    options->follow.json = options->json;
    if (!options->follow.motion.empty()) return follow(options->follow);
    if (options->file.empty()) throw CLI::RequiredError("FILE.h5 or --motion");
    replay(*options, *command);
  });
}

}  // namespace cli
