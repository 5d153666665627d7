// Recordings: written while a world steps, read, and played again.
#include "recording/recording.h"

#include <optional>
#include <string>

#include "base/format.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/results.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "recording/rows.h"

namespace mimo::capi {
namespace {

mimo_recorder_config default_recorder_config() {
  const recording::Options ours;
  mimo_recorder_config config{};
  config.struct_size = sizeof config;
  config.compression = ours.compression;
  config.state_seconds = ours.state_seconds;
  config.flush_seconds = ours.flush_seconds;
  return config;
}

std::string path_from(const char* path) {
  require(path != nullptr && *path != '\0', "path is {}, expected the path of a file",
          path == nullptr ? "NULL" : "\"\"");
  return path;
}

// The file of a recording, which has that dataset.
const recording::Reader& file_with(const mimo_recording* recording, const char* dataset) {
  const recording::Reader& file = open(recording).recording->file();
  require(dataset != nullptr, "dataset is NULL");
  if (!file.has_dataset(dataset)) fail(Status::kNotFound, "{} has no dataset \"{}\"", file.path(), dataset);
  return file;
}

std::string this_build() {
  return recording::build_name(format("libmimo {}, MuJoCo {}", mimo_version(), mimo_mujoco_version()));
}

recording::Options options_from(const char* path, const mimo_recorder_config& config) {
  recording::Options options;
  options.path = path_from(path);
  check_flag(config.replace, "replace");
  check_reserved(config.reserved, "reserved");
  options.keep = text(config.keep);
  options.compression = in_range(config.compression, ranges::recorder_config::compression);
  options.state_seconds = in_range(config.state_seconds, ranges::recorder_config::state_seconds);
  options.flush_seconds = in_range(config.flush_seconds, ranges::recorder_config::flush_seconds);
  options.replace = config.replace != 0;
  options.configuration = text(config.configuration);
  options.seed = std::to_string(config.seed);
  options.build = this_build();
  options.library = mimo_version();
  options.mujoco = mimo_mujoco_version();
  return options;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_recorder_config_init(mimo_recorder_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_recorder_config(), "config"); });
}

mimo_status mimo_recorder_open(mimo_env* env, const char* path, const mimo_recorder_config* config,
                               mimo_recorder** recorder) noexcept {
  return guard(env, [&] {
    mimo_recorder*& result = out(recorder, "recorder");
    const EnvObject& recorded = open(env);
    const mimo_recorder_config ours = read_struct(config, default_recorder_config(), "config");
    const recording::Options options = options_from(path, ours);
    recording::hdf5::load(text(ours.hdf5));
    auto object = std::make_unique<RecorderObject>();
    object->env = env;
    object->recorder = recording::Recorder::follow(recorded.aging(), options);
    result = wrap<mimo_recorder>(std::move(object));
  });
}

mimo_status mimo_recorder_flush(mimo_recorder* recorder) noexcept {
  return guard(recorder, [&] { open(recorder).recorder->flush(); });
}

mimo_status mimo_recorder_close(mimo_recorder* recorder) noexcept {
  return translate(recorder, [&] {
    if (peek_handle(recorder, HandleType::kRecorder) == nullptr) return;
    const Use<mimo_recorder> use(recorder);
    const RecorderObject& object = open(recorder);
    std::optional<Use<mimo_env>> use_of_env;
    if (peek_handle(object.env, HandleType::kEnv) != nullptr) use_of_env.emplace(object.env);
    const std::shared_ptr<recording::Recorder> inside = object.recorder;
    inside->close();
    end_with_call(recorder);
    inside->require_whole();
  });
}

mimo_status mimo_recording_open(const char* path, const char* hdf5, mimo_recording** recording) noexcept {
  return guard([&] {
    mimo_recording*& result = out(recording, "recording");
    const std::string file = path_from(path);
    recording::hdf5::load(text(hdf5));
    result = wrap<mimo_recording>(std::make_unique<RecordingObject>(file, this_build()));
  });
}

mimo_status mimo_recording_env(const mimo_recording* recording, const mimo_env_config* config,
                               const mimo_agent_config* senses, mimo_env** env) noexcept {
  return guard(recording, [&] {
    mimo_env*& result = out(env, "env");
    result = wrap_env(make_recorded(open(recording), config, senses));
  });
}

void mimo_recording_close(mimo_recording* recording) noexcept { destroy(recording); }

mimo_status mimo_recording_describe(const mimo_recording* recording, mimo_recording_info* info) noexcept {
  return guard(recording, [&] {
    const RecordingObject& object = open(recording);
    const recording::Recording& inside = *object.recording;
    mimo_recording_info ours{};
    ours.format_version = static_cast<uint32_t>(inside.file().integer("format_version"));
    ours.same_build = inside.build() == object.build ? 1 : 0;
    ours.steps = inside.steps();
    ours.states = inside.states();
    ours.actions = inside.actions();
    ours.agents = inside.agents();
    ours.bodies = inside.bodies();
    ours.step_seconds = inside.step_seconds();
    ours.build = inside.build().c_str();
    ours.this_build = object.build.c_str();
    ours.configuration = inside.configuration().c_str();
    ours.seed = inside.seed().c_str();
    ours.library = inside.library().c_str();
    ours.mujoco = inside.mujoco().c_str();
    write_described(info, ours, "info");
  });
}

mimo_status mimo_recording_size(const mimo_recording* recording, const char* dataset, size_t* rows,
                                size_t* row_bytes) noexcept {
  return guard(recording, [&] {
    const recording::Reader& file = file_with(recording, dataset);
    if (rows != nullptr) *rows = file.rows(dataset);
    if (row_bytes != nullptr) *row_bytes = file.row_bytes(dataset);
  });
}

mimo_status mimo_recording_read(const mimo_recording* recording, const char* dataset, size_t first, size_t rows,
                                void* values, size_t value_bytes) noexcept {
  return guard(recording, [&] {
    const recording::Reader& file = file_with(recording, dataset);
    const std::size_t there = file.rows(dataset), bytes = file.row_bytes(dataset);
    require(first <= there && rows <= there - first, "first is {} and rows is {}, but '{}' has {} rows", first, rows,
            dataset, there);
    auto* to = static_cast<std::uint8_t*>(values);
    check_buffer(to, value_bytes, rows * bytes, "values");
    require(to != nullptr || rows * bytes == 0, "values is NULL");
    file.read(dataset, first, rows, {to, rows * bytes});
  });
}

mimo_status mimo_recording_seek(mimo_recording* recording, mimo_env* env, size_t step, uint32_t how,
                                size_t* at) noexcept {
  return guard(recording, [&] {
    recording::Recording& inside = *open(recording).recording;
    const Use<mimo_env> use(env);
    const EnvObject& object = open(env);
    check_bits(how, MIMO_REPLAY_FIELDS | MIMO_REPLAY_JOINTS, "how");
    const recording::Play play{(how & MIMO_REPLAY_FIELDS) != 0, (how & MIMO_REPLAY_JOINTS) != 0,
                               object.task_is_missing};
    const std::size_t begin = inside.seek(object.aging(), step, play);
    if (at != nullptr) *at = begin;
  });
}

mimo_status mimo_recording_step(mimo_recording* recording, mimo_env* env, void* block, size_t block_bytes,
                                const mimo_env_results* results) noexcept {
  return guard(recording, [&] {
    recording::Recording& inside = *open(recording).recording;
    const Use<mimo_env> use(env);
    blueprint::AgingWorld& target = open(env).aging();
    const env::World& world = target.world();
    const env::Results to = results_of(world, results);
    inside.play(target, block_of(world.layout(), block, block_bytes), to);
  });
}

mimo_status mimo_recording_report(const mimo_recording* recording, mimo_replay_report* report) noexcept {
  return guard(recording, [&] {
    const recording::Recording& inside = *open(recording).recording;
    const recording::Verdict& verdict = inside.verdict();
    mimo_replay_report ours{};
    ours.identical = verdict.identical ? 1 : 0;
    ours.next = inside.next();
    ours.steps = verdict.steps;
    ours.first_difference = verdict.first;
    ours.largest_difference = verdict.largest;
    ours.differs_most_in = verdict.table.c_str();
    write_described(report, ours, "report");
  });
}

}  // extern "C"
