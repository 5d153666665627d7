// Many worlds of one description, stepped by one pool of threads; their infants may be of different ages.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "access/access.h"
#include "base/pool.h"
#include "base/span.h"
#include "batch/step.h"
#include "batch/threads.h"
#include "engine/scratch.h"

namespace mimo::batch {

using CompiledWorlds = std::vector<env::CompiledWorldPtr>;

// Masks have a byte for each world, 0 for those to be left alone; a null mask means all. Every operation goes through
// all worlds whatever happens to one, then delivers their messages and throws the first failure that is not settled.
class Batch : private Job {
 public:
  // What the border knows world i by.
  using HostOf = FunctionRef<const void*(std::size_t world)>;

  // World i is one of compiled[i % compiled.size()]. Throws Status::kInvalidArgument, naming the world, where not all
  // observe, act and are rewarded alike. `ages` may be null where infants never change.
  Batch(const CompiledWorlds& compiled, const Options& options, HostOf host_of = {},
        const blueprint::WorldsByAgePtr& ages = {});
  ~Batch();
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  std::size_t size() const { return worlds_.size(); }
  std::size_t threads() const { return pool_.threads(); }
  env::World& world(std::size_t i) { return worlds_[i]->world(); }
  const env::World& world(std::size_t i) const { return worlds_[i]->world(); }
  blueprint::AgingWorld& aging(std::size_t i) const { return *worlds_[i]; }
  // Of all worlds: names and shapes that they have in common, receptors of the first one as it was made, the widest
  // bounds of all that ever were.
  const env::LiveDescription& description() const { return description_; }
  const Report& report(std::size_t i) const { return reports_[i]; }

  // Throws while the batch is at work, except for the thread that is on this very world.
  void require_access(std::size_t world) const;
  // Throws while the batch is at work.
  void require_idle() const;
  bool works_on_this_thread() const;
  // Whether this thread is at work on that very world. Looks at no member: others may be destroying them.
  bool is_at(std::size_t world) const { return current_thread().batch == this && current_thread().world == world; }

  // Null seeds: every world goes on with its own stream. World i becomes one of next[i]; null: it stays what it is; an
  // empty list: so do all. Nothing happens where the worlds of one of them are not like those here.
  void reset(const std::uint64_t* seeds, const std::uint8_t* mask, std::uint8_t* blocks,
             const CompiledWorlds& next = {});
  void step(const float* actions, const Output& output);
  // A step in two parts. Actions and output belong to the batch in between.
  void send(const float* actions, const Output& output);
  void receive();
  void observe(const std::uint8_t* mask, std::uint8_t* blocks);

  // Values have a row for each world.
  template <typename T>
  void get(const access::Quantity& quantity, const access::Ids& ids, bool now, const std::uint8_t* mask,
           T* values) const {
    require_idle();
    const std::size_t width = access::width(world(0), quantity, ids);
    for (std::size_t i = 0; i < size(); ++i) {
      if (mask == nullptr || mask[i] != 0) access::get(world(i), quantity, ids, now, {values + i * width, width});
    }
  }
  void set(const access::Quantity& quantity, const access::Ids& ids, const std::uint8_t* mask, const double* values);

  // Of the world whose state is longest: worlds of other ages remember more or less.
  std::size_t state_bytes() const;
  // One state behind the other, at distances of state_bytes(), with zeros between them.
  void save(const std::uint8_t* mask, std::uint8_t* states);
  // As many bytes for each world, or a single state, which all load; where one is refused, none changes. Tells of the
  // world where most started afresh.
  env::LoadReport load(const std::uint8_t* mask, Span<const std::uint8_t> states);

 private:
  // What is done to a world; what it does not settle itself, the report tells afterwards.
  using Work = FunctionRef<void(std::size_t world, Report& report)>;

  // What all worlds are at.
  struct Operation {
    Work work;
    const std::uint8_t* mask = nullptr;
    std::int32_t* status = nullptr;  // of each world, for the caller
    CurrentThread caller;            // that waits for the work

    bool concerns(std::size_t world) const { return mask == nullptr || mask[world] != 0; }
  };

  using RenderersPtr = std::shared_ptr<SharedRenderers>;

  // Made where no world is one of this compiled one, with as many renderers at once as furnished_ says.
  RenderersPtr renderers_of(const env::CompiledWorldPtr& compiled);
  env::Services services_of(std::size_t world, const env::CompiledWorldPtr& compiled);
  void add_world(const env::CompiledWorldPtr& compiled, const blueprint::WorldsByAgePtr& ages, const void* host);
  void require_like_the_others(const CompiledWorlds& next, const std::uint8_t* mask,
                               std::vector<RenderersPtr>& renderers);
  env::LoadReport begin_load_row(std::size_t world, Span<const std::uint8_t> states);
  void require_undisturbed() const;
  void begin(const Operation& operation);
  void perform(const std::uint8_t* mask, Work work, std::int32_t* status = nullptr);
  void finish();
  void run(std::size_t world, std::size_t thread) noexcept override;
  void attempt(std::size_t world, Report& report) noexcept;

  Options options_;
  std::size_t threads_;
  std::size_t furnished_;
  engine::ScratchSupply scratch_;
  std::mutex mutex_;                                       // of renderers, as worlds may change by themselves
  std::vector<std::weak_ptr<SharedRenderers>> renderers_;  // one for each compiled world that worlds are of
  env::LiveDescription description_;
  std::vector<LogQueue> log_queues_;  // by worlds, as these
  std::vector<std::unique_ptr<blueprint::AgingWorld>> worlds_;
  std::vector<Report> reports_;
  std::vector<env::LoadReport> loaded_;  // by the worlds, in the last load
  Pool pool_;
  Operation operation_;
  std::optional<Step> sent_;
  std::atomic<bool> busy_{false};
};

}  // namespace mimo::batch
