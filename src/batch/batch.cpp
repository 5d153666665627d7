#include "batch/batch.h"

#include <algorithm>

#include "base/fail.h"
#include "base/format.h"
#include "common/cores.h"

namespace mimo::batch {

namespace {

std::size_t thread_count(const Options& options) {
  const std::size_t wanted = options.threads != 0 ? options.threads : usable_cores();
  return std::min(wanted, options.worlds);
}

void check_like(std::size_t world, const env::Description& expected, const env::Description& own) {
  try {
    check_alike(expected, own);
  } catch (const Error& error) {
    fail(error.status(), "world {}: {}", world, error.message());
  }
}

}  // namespace

Batch::Batch(const CompiledWorlds& compiled, const Options& options, HostOf host_of,
             const blueprint::WorldsByAgePtr& ages)
    : options_(options),
      threads_(thread_count(options)),
      furnished_(compiled.size() == 1 ? threads_ : 1),  // of several models a thread may never draw them all
      scratch_(threads_),
      reports_(options.worlds),
      loaded_(options.worlds),
      pool_(threads_) {
  log_queues_.reserve(options.worlds);
  worlds_.reserve(options.worlds);
  for (std::size_t i = 0; i < options.worlds; ++i) {
    add_world(compiled[i % compiled.size()], ages, host_of ? host_of(i) : nullptr);
    if (i >= compiled.size()) continue;
    scratch_.provide(world(i).model(), world(i).data());
    const env::Description own = describe(world(i));
    if (i == 0) description_.begin_as(own);
    check_like(i, *description_.read(), own);
    description_.widen(own);
  }
  furnished_ = 1;
}

Batch::~Batch() {
  if (sent_) pool_.wait();
}

// Callbacks of the host concern all worlds alike.
void Batch::require_undisturbed() const { world(0).physics().require_undisturbed(); }

void Batch::require_idle() const {
  if (!busy_.load(std::memory_order_relaxed)) return;
  fail(Status::kBusy, "the batch is at work: {}",
       works_on_this_thread() ? "a task cannot use the batch that runs it"
                              : "only mimo_batch_receive can follow mimo_batch_send");
}

void Batch::require_access(std::size_t world) const {
  if (!busy_.load(std::memory_order_relaxed) || is_at(world)) return;
  fail(Status::kBusy, "world {} belongs to a batch that is at work; call mimo_batch_receive first", world);
}

bool Batch::works_on_this_thread() const { return works_for(this); }

// Worlds without a given seed still differ from each other.
void Batch::add_world(const env::CompiledWorldPtr& compiled, const blueprint::WorldsByAgePtr& ages, const void* host) {
  const std::size_t i = worlds_.size();
  const std::uint64_t seed = i;
  log_queues_.emplace_back(compiled->services.log, this);
  const auto services = [this, i](const env::CompiledWorldPtr& of) { return services_of(i, of); };
  worlds_.push_back(std::make_unique<blueprint::AgingWorld>(
      ages, compiled, blueprint::Surroundings{{seed, i, host}, services, &description_}));
}

env::Services Batch::services_of(std::size_t world, const env::CompiledWorldPtr& compiled) {
  env::Services services = compiled->services;
  services.renderer = renderers_of(compiled);
  services.log = log_queues_[world].slot();
  return services;
}

Batch::RenderersPtr Batch::renderers_of(const env::CompiledWorldPtr& compiled) {
  const std::lock_guard lock(mutex_);
  const auto gone = [](const std::weak_ptr<SharedRenderers>& some) { return some.expired(); };
  renderers_.erase(std::remove_if(renderers_.begin(), renderers_.end(), gone), renderers_.end());
  for (const std::weak_ptr<SharedRenderers>& some : renderers_) {
    if (RenderersPtr known = some.lock(); known != nullptr && known->compiled() == compiled) return known;
  }
  auto made = std::make_shared<SharedRenderers>(compiled, threads_, this);
  if (env::draws(compiled->agents, compiled->options)) made->furnish(furnished_);
  renderers_.push_back(made);
  return made;
}

void Batch::reset(const std::uint64_t* seeds, const std::uint8_t* mask, std::uint8_t* blocks,
                  const CompiledWorlds& next) {
  require_undisturbed();
  require_idle();
  std::vector<RenderersPtr> renderers;
  require_like_the_others(next, mask, renderers);
  perform(mask, [&](std::size_t i, Report&) {
    const std::uint64_t* seed = seeds == nullptr ? nullptr : seeds + i;
    const bool stays = next.empty() || next[i] == nullptr;
    worlds_[i]->reset_as(stays ? worlds_[i]->compiled() : next[i], seed, block_of(worlds_, blocks, i));
  });
}

// Of a compiled world that no world here is one of, one is made to see that it is like the others. The renderers that
// it needs are kept for those that come.
void Batch::require_like_the_others(const CompiledWorlds& next, const std::uint8_t* mask,
                                    std::vector<RenderersPtr>& renderers) {
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (next[i] == nullptr || (mask != nullptr && mask[i] == 0)) continue;
    const auto is_of_it = [&](const auto& world) { return world->compiled() == next[i]; };
    const auto made_for_it = [&](const RenderersPtr& some) { return some->compiled() == next[i]; };
    if (std::any_of(worlds_.begin(), worlds_.end(), is_of_it)) continue;
    if (std::any_of(renderers.begin(), renderers.end(), made_for_it)) continue;
    renderers.push_back(renderers_of(next[i]));
    try {
      worlds_[i]->require_alike(next[i]);
    } catch (const Error& error) {
      fail(error.status(), "world {}: {}", i, error.message());
    }
  }
}

void Batch::step(const float* actions, const Output& output) {
  require_undisturbed();
  perform(nullptr, Step(worlds_, options_, actions, output), output.status);
}

void Batch::send(const float* actions, const Output& output) {
  require_undisturbed();
  require_idle();
  sent_.emplace(worlds_, options_, actions, output);
  begin({*sent_, nullptr, output.status, {}});
  try {
    pool_.start(*this, size());
  } catch (...) {  // no thread to be had
    sent_.reset();
    busy_ = false;
    throw;
  }
}

void Batch::receive() {
  if (works_on_this_thread()) {
    fail(Status::kBusy, "a task cannot receive the step that it is part of: it would wait for itself");
  }
  if (!sent_) fail(Status::kBusy, "mimo_batch_receive without mimo_batch_send");
  pool_.wait();
  sent_.reset();
  finish();
}

void Batch::observe(const std::uint8_t* mask, std::uint8_t* blocks) {
  require_undisturbed();
  perform(mask, [&](std::size_t i, Report&) { world(i).observe(block_of(worlds_, blocks, i)); });
}

// Copying is so quick that waking threads for it would take longer.
void Batch::set(const access::Quantity& quantity, const access::Ids& ids, const std::uint8_t* mask,
                const double* values) {
  require_idle();
  const std::size_t width = access::width(world(0), quantity, ids);
  const auto row = [&](std::size_t i) { return Span<const double>(values + i * width, width); };
  for (std::size_t i = 0; i < size(); ++i) {  // all before any is changed
    if (mask != nullptr && mask[i] == 0) continue;
    access::check_settable(world(i), quantity, ids, row(i));
  }
  perform(mask, [&](std::size_t i, Report&) { access::set(world(i), quantity, ids, row(i)); });
}

std::size_t Batch::state_bytes() const {
  std::size_t bytes = 0;
  for (const auto& world : worlds_) bytes = std::max(bytes, world->world().state_bytes());
  return bytes;
}

void Batch::save(const std::uint8_t* mask, std::uint8_t* states) {
  const std::size_t row = state_bytes();
  perform(mask, [&](std::size_t i, Report&) {
    const std::size_t bytes = world(i).state_bytes();
    std::uint8_t* own = states + i * row;
    world(i).save({own, bytes});
    std::fill(own + bytes, own + row, std::uint8_t{0});
  });
}

env::LoadReport Batch::load(const std::uint8_t* mask, Span<const std::uint8_t> states) {
  const bool shared = env::is_one_state(states);
  if (!shared && states.size() % size() != 0) {
    env::check_version(states);
    fail(Status::kInvalidArgument, "state_bytes is {}, expected {} ({} worlds x {}), or a single state of its own size",
         states.size(), size() * state_bytes(), size(), state_bytes());
  }
  require_idle();
  std::fill(loaded_.begin(), loaded_.end(), env::LoadReport{});
  try {
    perform(mask, [&](std::size_t i, Report&) {
      loaded_[i] = shared ? world(i).begin_load(states) : begin_load_row(i, states);
    });
  } catch (...) {
    for (std::size_t i = 0; i < size(); ++i) world(i).take_back_load();
    throw;
  }
  perform(mask, [&](std::size_t i, Report&) { world(i).finish_load(); });
  const auto fewer = [](const env::LoadReport& a, const env::LoadReport& b) { return a.fresh < b.fresh; };
  return std::move(*std::max_element(loaded_.begin(), loaded_.end(), fewer));
}

// States of other worlds may be of another length than this batch's own; as a rule such rows are a mistake.
env::LoadReport Batch::begin_load_row(std::size_t i, Span<const std::uint8_t> states) {
  const std::size_t row = states.size() / size(), own = state_bytes();
  try {
    return world(i).begin_load(env::state_in(states.part(i * row, row)));
  } catch (const Error& error) {
    if (row == own || error.status() != Status::kFile) throw;
    fail(Status::kFile, "{}; state_bytes is {}, so {} for each of {} worlds, expected {} for this batch's own states",
         error.message(), states.size(), row, size(), own * size());
  }
}

void Batch::begin(const Operation& operation) {
  require_idle();
  operation_ = operation;
  busy_ = true;
}

void Batch::perform(const std::uint8_t* mask, Work work, std::int32_t* status) {
  begin({work, mask, status, current_thread()});
  pool_.run(*this, size());
  finish();
}

void Batch::finish() {
  busy_ = false;
  for (LogQueue& queue : log_queues_) queue.deliver();
  std::size_t failures = 0, first = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!operation_.concerns(i) || reports_[i].status == Status::kOk || reports_[i].settled) continue;
    if (failures++ == 0) first = i;
  }
  if (failures == 0) return;
  const std::string others = failures == 1 ? "" : format(" (and {} more)", failures - 1);
  fail(reports_[first].status, "world {}{}: {}", first, others, reports_[first].message);
}

void Batch::run(std::size_t world, std::size_t thread) noexcept {
  if (!operation_.concerns(world)) return;
  const AtWork at({this, world, thread, &operation_.caller});
  Report& report = reports_[world];
  attempt(world, report);
  if (operation_.status != nullptr) operation_.status[world] = static_cast<std::int32_t>(report.status);
}

void Batch::attempt(std::size_t world, Report& report) noexcept {
  caught(
      [&] {
        report.settled = false;
        operation_.work(world, report);
        if (!report.settled) report.note(Status::kOk, "");
      },
      [&](Status status, const char* text) { report.note(status, text); });
}

}  // namespace mimo::batch
