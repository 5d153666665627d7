// Many worlds of one model, stepped by one pool of threads.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/function_ref.h"
#include "base/pool.h"
#include "batch/mailbox.h"
#include "batch/options.h"
#include "batch/report.h"
#include "batch/step.h"
#include "batch/studio.h"
#include "batch/workplace.h"
#include "env/access.h"
#include "env/world.h"

namespace mimo::batch {

// Masks have a byte for each world, 0 for those to be left alone; a null mask means all. Every operation goes through
// all worlds whatever happens to one, then delivers their messages and throws the first failure that is not settled.
class Batch : private Job {
 public:
  // What the border knows world i by.
  using HostOf = FunctionRef<const void*(std::size_t world)>;

  Batch(const env::Kit& kit, const Options& options, HostOf host_of = {});
  ~Batch();
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  std::size_t size() const { return worlds_.size(); }
  std::size_t threads() const { return pool_.threads(); }
  env::World& world(std::size_t i) { return *worlds_[i]; }
  const env::World& world(std::size_t i) const { return *worlds_[i]; }
  const Report& report(std::size_t i) const { return reports_[i]; }

  // Throws while the batch is at work, except for the thread that is on this very world.
  void require_access(std::size_t world) const;
  // Throws while the batch is at work.
  void require_idle() const;
  bool works_on_this_thread() const;

  // Null seeds: every world goes on with its own stream.
  void reset(const std::uint64_t* seeds, const std::uint8_t* mask, std::uint8_t* blocks);
  void step(const float* actions, const Output& output);
  // A step in two parts. Actions and output belong to the batch in between.
  void send(const float* actions, const Output& output);
  void receive();
  void observe(const std::uint8_t* mask, std::uint8_t* blocks);

  // Values have a row for each world.
  template <typename T>
  void get(env::Quantity quantity, const env::Ids& ids, bool now, const std::uint8_t* mask, T* values) const {
    require_idle();
    const std::size_t width = env::width(world(0), quantity, ids);
    for (std::size_t i = 0; i < size(); ++i) {
      if (mask == nullptr || mask[i] != 0) env::get(world(i), quantity, ids, now, {values + i * width, width});
    }
  }
  void set(env::Quantity quantity, const env::Ids& ids, const std::uint8_t* mask, const double* values);

  // One state behind the other, all of one size. A single one is loaded by all worlds.
  void save(const std::uint8_t* mask, std::uint8_t* states);
  // Tells of the world where most started afresh.
  env::LoadReport load(const std::uint8_t* mask, Span<const std::uint8_t> states);

 private:
  // What is done to a world; what it does not settle itself, the report tells afterwards.
  using Work = FunctionRef<void(std::size_t world, Report& report)>;

  // What all worlds are at.
  struct Operation {
    Work work;
    const std::uint8_t* mask = nullptr;
    std::int32_t* status = nullptr;  // of each world, for the caller
    Workplace caller;                // that waits for the work

    bool concerns(std::size_t world) const { return mask == nullptr || mask[world] != 0; }
  };

  void begin(const Operation& operation);
  void perform(const std::uint8_t* mask, Work work, std::int32_t* status = nullptr);
  void finish();
  void run(std::size_t world, std::size_t thread) noexcept override;
  void attempt(std::size_t world, Report& report) noexcept;

  Options options_;
  Studio studio_;
  std::vector<Mailbox> mailboxes_;
  std::vector<std::unique_ptr<env::World>> worlds_;
  std::vector<Report> reports_;
  std::vector<env::LoadReport> loaded_;  // by the worlds, in the last load
  Pool pool_;
  Operation operation_;
  std::optional<Step> sent_;
  std::atomic<bool> busy_{false};
};

}  // namespace mimo::batch
