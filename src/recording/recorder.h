// Follows a world's steps and writes them into a file: what was done, what came of it, and states to go on from.
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "blueprint/aging_world.h"
#include "env/step.h"
#include "recording/file.h"
#include "recording/rows.h"

namespace mimo::recording {

struct Options {
  std::string path;
  std::string keep;          // senses and fields with commas between them, "none", "all"; "": what most want
  double state_seconds = 1;  // of simulated time, between states that are kept
  double flush_seconds = 1;  // of real time
  unsigned compression = 4;
  bool replace = false;                                     // a whole recording that is there
  std::string configuration, seed, build, library, mujoco;  // attributes
};

// Between two steps a host may do anything to its world. What that was does not matter: where the world tells that
// something may have changed since the last step, its state is kept, and marked as one that a replay has to load.
class Recorder : public env::StepObserver {
 public:
  // Throws before the file is made where an option is wrong. The world tells it of its steps from now on.
  static std::shared_ptr<Recorder> follow(const blueprint::AgingWorld& aging, const Options& options);

  // Throws what could not be written, now or before.
  void flush();
  // The world is not followed any more. Throws, with nothing changed, within a step of the world only.
  void close();
  // Throws what could not be written, before or at its end.
  void require_whole() const;

  std::uint8_t* step_begins(const env::World& world, std::uint8_t* block) noexcept override;
  std::uint8_t* movement_begins(const env::World& world, std::uint8_t* block) noexcept override;
  void step_ends(env::World& world, Span<const float> actions, const std::uint8_t* block) noexcept override;
  void step_failed() noexcept override;
  void goes_on_in(env::World& world) noexcept override;
  void ends(const env::World& world) noexcept override;

 private:
  // A kept field: where it lies in a block, and in the file.
  struct Kept {
    std::string table;
    std::size_t offset;
  };
  using Clock = std::chrono::steady_clock;

  Recorder(const blueprint::AgingWorld& aging, const Options& options);
  void describe(const env::World& world, const Options& options);
  void describe_results(const env::World& world);
  void describe_world(const document::Package& package);
  void describe_fields(const env::World& world, const std::vector<std::size_t>& kept);  // by number
  bool changed(const env::World& world) const;
  void keep_state(const env::World& world, StateMark mark);
  void keep_body(const env::World& world, const std::string& document);
  void write_results(const env::World& world);
  void begin(const env::World& world, bool moved);
  std::uint8_t* begins(const env::World& world, std::uint8_t* block, bool moved) noexcept;
  void write(const env::World& world, Span<const float> actions, const std::uint8_t* block);
  void finish() noexcept;
  template <typename Work>
  void attempt(Work&& work) noexcept;
  void complain(const env::World& world) const;

  std::mutex mutex_;  // flush() may come from another thread than the steps
  blueprint::WorldsByAgePtr worlds_;
  env::World* world_;
  std::unique_ptr<Writer> file_;  // null when it is closed
  std::string trouble_;           // what went wrong first, "" for nothing
  bool told_ = false;             // to the user
  bool stepping_ = false;
  bool moved_ = false;       // the last step followed a known movement
  bool begun_ = false;       // with a first state on its way to the disk
  std::size_t state_every_;  // steps
  double step_seconds_, flush_seconds_;
  bool own_task_;  // of the user's own, which a replay may not have
  std::vector<Kept> fields_;
  std::uint64_t changes_ = 0;  // of the world, when the last step ended, or where the task is the user's own, began
  std::vector<std::uint8_t> own_block_, state_;
  std::vector<float> actions_;
  std::vector<double> numbers_;
  StepResults results_;
  Growths body_;
  std::int64_t steps_ = 0, bodies_ = 0;
  Clock::time_point flushed_ = Clock::now();
};

}  // namespace mimo::recording
