// Many worlds of one model, stepped by one pool of threads.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/pool.h"
#include "batch/mailbox.h"
#include "batch/options.h"
#include "batch/workplace.h"
#include "batch/studio.h"
#include "env/access.h"
#include "env/world.h"

namespace mimo::batch {

// What became of a world in the last call that concerned it.
struct Report {
  Status status = Status::kOk;
  std::string message;
  bool settled = false;  // it failed, and was or will be restarted as configured
};

// Masks have a byte for each world, 0 for those to be left alone; a null mask means all. Every operation goes through
// all worlds whatever happens to one, then delivers their messages and throws the first failure that is not settled.
class Batch : private Job {
 public:
  // Gives the options of world i; its log, seed and renderer are the batch's business.
  using OptionsOf = std::function<env::EnvOptions(std::size_t world)>;

  Batch(const engine::ModelPtr& model, const std::vector<env::AgentOptions>& agents, const OptionsOf& options_of,
        const Options& options);
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
  void get(env::Quantity quantity, Span<const std::int32_t> ids, const std::uint8_t* mask, double* values) const;
  void set(env::Quantity quantity, Span<const std::int32_t> ids, const std::uint8_t* mask, const double* values);

  void set_face(std::size_t agent, const std::string& name, const std::uint8_t* mask);

  // States are `stride` bytes apart; with a stride of 0 all worlds load the same one.
  void save(const std::uint8_t* mask, std::uint8_t* states);
  void load(const std::uint8_t* mask, const std::uint8_t* states, std::size_t stride);

 private:
  using Work = void (Batch::*)(std::size_t world);

  // The operands of the operation in progress.
  struct Call {
    Work work = nullptr;
    Workplace caller;  // that waits for the work
    const std::uint8_t* mask = nullptr;
    const float* actions = nullptr;
    const std::uint64_t* seeds = nullptr;
    Output output;
    env::Quantity quantity{};
    Span<const std::int32_t> ids;
    const double* values = nullptr;
    std::size_t width = 0;
    std::uint8_t* saved = nullptr;
    const std::uint8_t* to_load = nullptr;
    std::size_t stride = 0;
  };

  static Call step_call(const float* actions, const Output& output);
  void begin(const Call& call);
  void perform(Call call);
  void finish();
  void run(std::size_t world, std::size_t thread) noexcept override;
  void note(std::size_t world, Status status, const char* message) noexcept;
  bool concerns(std::size_t world) const { return call_.mask == nullptr || call_.mask[world] != 0; }
  std::uint8_t* block(std::size_t world) const;

  void reset_world(std::size_t world);
  void step_world(std::size_t world);
  void observe_world(std::size_t world) { worlds_[world]->observe(block(world)); }
  void set_world(std::size_t world);
  void save_world(std::size_t world);
  void load_world(std::size_t world);

  // The parts of step_world; see step.cpp.
  bool due_for_reset(std::size_t world) const;
  void try_step(std::size_t world, Span<const float> actions);
  void end_episode(std::size_t world);
  void restart(std::size_t world);
  void blank(std::size_t world, bool cut_off);
  Span<const float> actions_of(std::size_t world) const;
  env::Results results_of(std::size_t world) const;

  Options options_;
  std::size_t agents_;
  Studio studio_;
  std::vector<Mailbox> mailboxes_;
  std::vector<std::unique_ptr<env::World>> worlds_;
  std::vector<Report> reports_;
  Pool pool_;
  Call call_;
  std::atomic<bool> busy_{false};
  bool sent_ = false;
};

}  // namespace mimo::batch
