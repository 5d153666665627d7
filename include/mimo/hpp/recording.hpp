/**
 * @file mimo/hpp/recording.hpp
 * Recordings: runs in files, written while they happen, and played again. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_RECORDING
#define MIMO_HPP_RECORDING

#include <cstdint>
#include <string>
#include <vector>

#include "env.hpp"

namespace mimo {
inline namespace v1_0 {

namespace detail {
inline void close_recorder(mimo_recorder *recorder) { static_cast<void>(mimo_recorder_close(recorder)); }
inline void destroy_recording(mimo_recording *recording) { mimo_recording_close(recording); }
}  // namespace detail

inline mimo_recorder_config recorder_config() { return detail::defaults(mimo_recorder_config_init); }

/// Records a world's steps as long as it lives:
///   mimo::Recorder recorder(env, "run.h5");
///   ...
///   recorder.close();  // throws where the disk was full; the destructor says nothing
class Recorder : public Handle<mimo_recorder, detail::close_recorder> {
 public:
  Recorder(Env &env, const std::string &path, const mimo_recorder_config &config = recorder_config())
      : Recorder(env.get(), path, config) {}
  /// Of a world of a batch, too.
  Recorder(mimo_env *env, const std::string &path, const mimo_recorder_config &config = recorder_config())
      : Handle(open(env, path, config)) {}

  void flush() { check(mimo_recorder_flush(get())); }
  void close() { check(mimo_recorder_close(get())); }

 private:
  static mimo_recorder *open(mimo_env *env, const std::string &path, const mimo_recorder_config &config) {
    mimo_recorder *recorder = nullptr;
    check(mimo_recorder_open(env, path.c_str(), &config, &recorder));
    return recorder;
  }
};

/// A recording that is read, and played again in a world like the one that was recorded.
class Recording : public Handle<mimo_recording, detail::destroy_recording> {
 public:
  explicit Recording(const std::string &path, const char *hdf5 = nullptr) : Handle(open(path, hdf5)) {}

  /// Its strings live as long as the recording.
  mimo_recording_info info() const {
    mimo_recording_info info = detail::described<mimo_recording_info>();
    check(mimo_recording_describe(get(), &info));
    return info;
  }
  /// How many rows a dataset has.
  std::size_t rows(const std::string &dataset) const {
    std::size_t rows = 0;
    check(mimo_recording_size(get(), dataset.c_str(), &rows, nullptr));
    return rows;
  }
  /// Rows of a dataset, of the type that it has in the file: actions and most fields float, joints and rewards double.
  template <typename T>
  std::vector<T> read(const std::string &dataset, std::size_t first, std::size_t rows) const {
    std::size_t row_bytes = 0;
    check(mimo_recording_size(get(), dataset.c_str(), nullptr, &row_bytes));
    std::vector<T> values(rows * row_bytes / sizeof(T));
    check(mimo_recording_read(get(), dataset.c_str(), first, rows, values.data(), values.size() * sizeof(T)));
    return values;
  }
  template <typename T>
  std::vector<T> read(const std::string &dataset) const {
    return read<T>(dataset, 0, rows(dataset));
  }

  /// Brings along a sense of your own that the recorded world had.
  inline void add_sense(const mimo_sense &sense);
  inline void load_sense(const std::string &path);
  /// The recorded world, made anew out of the file; configs as those of mimo_recording_env.
  Env env(const mimo_env_config *config = nullptr, const mimo_agent_config *senses = nullptr) const {
    mimo_env *made = nullptr;
    check(mimo_recording_env(get(), config, senses, &made));
    return Env(made);
  }
  /// Begins a replay at the last kept state that is not later than a step; returns that state's step. MIMO_REPLAY_ bits
  /// say how.
  std::size_t seek(Env &env, std::size_t step = 0, std::uint32_t how = MIMO_REPLAY_FIELDS) {
    std::size_t at = 0;
    check(mimo_recording_seek(get(), env.get(), step, how, &at));
    return at;
  }
  /// Plays the next step.
  void step(Env &env, Block &block, Results &results) {
    const mimo_env_results to = results.raw();
    check(mimo_recording_step(get(), env.get(), block.data(), block.bytes(), &to));
  }
  /// What was compared so far.
  mimo_replay_report report() const {
    mimo_replay_report report = detail::described<mimo_replay_report>();
    check(mimo_recording_report(get(), &report));
    return report;
  }

 private:
  static mimo_recording *open(const std::string &path, const char *hdf5) {
    mimo_recording *recording = nullptr;
    check(mimo_recording_open(path.c_str(), hdf5, &recording));
    return recording;
  }
};

}  // namespace v1_0
}  // namespace mimo

#endif
