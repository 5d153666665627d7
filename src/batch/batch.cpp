#include "batch/batch.h"

#include <algorithm>
#include <new>
#include <thread>

#include "base/fail.h"
#include "base/format.h"
#include "env/succession.h"

namespace mimo::batch {

namespace {

std::size_t thread_count(const Options& options) {
  const std::size_t wanted = options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  return std::min(wanted, options.worlds);
}

}  // namespace

Batch::Batch(const Kits& kits, const Options& options, HostOf host_of)
    : options_(options),
      threads_(thread_count(options)),
      reports_(options.worlds),
      loaded_(options.worlds),
      pool_(threads_) {
  for (std::size_t i = 0; i < options.worlds; ++i) {
    const std::uint64_t seed = i;  // worlds that nobody seeds are not all alike
    identities_.push_back({seed, i, host_of ? host_of(i) : nullptr});
  }
  mailboxes_.reserve(options.worlds);
  stocks_.reserve(options.worlds);
  worlds_.reserve(options.worlds);
  // Of several models a thread may never draw them all.
  const std::size_t renderers = kits.size() == 1 ? threads_ : 1;
  for (std::size_t i = 0; i < options.worlds; ++i) add_world(kits[i % kits.size()], renderers);
}

Batch::~Batch() {
  if (sent_) pool_.wait();
}

void Batch::require_idle() const {
  if (!busy_.load(std::memory_order_relaxed)) return;
  fail(Status::kBusy, "the batch is at work: {}",
       works_on_this_thread() ? "a task cannot use the batch whose step it is part of"
                              : "only mimo_batch_receive can follow mimo_batch_send");
}

void Batch::require_access(std::size_t world) const {
  if (!busy_.load(std::memory_order_relaxed) || is_at(world)) return;
  fail(Status::kBusy, "world {} belongs to a batch that is at work: mimo_batch_receive comes first", world);
}

bool Batch::works_on_this_thread() const { return works_for(this); }

void Batch::add_world(const env::KitPtr& kit, std::size_t renderers) {
  const std::size_t i = worlds_.size();
  mailboxes_.emplace_back(kit->services.log, this);
  const StockPtr stock = stock_of(kit, renderers);
  const bool first = stock.use_count() == 1;
  stocks_.push_back(stock);
  worlds_.push_back(make_world(i, *stock));
  if (!first) return;
  env::Description own = describe(*worlds_[i]);
  if (i == 0) description_.begin_as(own);
  check_like_the_others(i, own);
  description_.widen(own);
}

std::unique_ptr<env::World> Batch::make_world(std::size_t world, Stock& stock) {
  env::Services services = stock.kit->services;
  services.renderer = &stock.studio;
  services.log = mailboxes_[world].slot();
  return env::make_world(*stock.kit, services, identities_[world]);
}

StockPtr Batch::stock_of(const env::KitPtr& kit, std::size_t renderers) {
  const auto same = [&](const StockPtr& stock) { return stock->kit == kit; };
  const auto known = std::find_if(stocks_.begin(), stocks_.end(), same);
  if (known != stocks_.end()) return *known;
  auto stock = std::make_shared<Stock>(kit, threads_, this);
  if (env::draws(kit->agents, kit->options)) stock->studio.furnish(renderers);
  return stock;
}

void Batch::check_like_the_others(std::size_t world, const env::Description& description) const {
  try {
    check_alike(*description_.read(), description);
  } catch (const Error& error) {
    fail(error.status(), "world {}: {}", world, error.what());
  }
}

void Batch::reset(const std::uint64_t* seeds, const std::uint8_t* mask, std::uint8_t* blocks, const Kits& kits) {
  world(0).physics().require_undisturbed();
  require_idle();
  const std::vector<StockPtr> next = stocks_for(kits, mask);
  perform(mask, [&](std::size_t i, Report&) {
    const std::uint64_t* seed = seeds == nullptr ? nullptr : seeds + i;
    std::uint8_t* block = block_of(worlds_, blocks, i);
    if (next.empty() || next[i] == stocks_[i]) return worlds_[i]->reset(seed, block);
    env::take_over(worlds_[i], make_world(i, *next[i]), seed, block);
    stocks_[i] = next[i];
  });
}

// Of what no world here is yet, one is made to see that it is like the others.
std::vector<StockPtr> Batch::stocks_for(const Kits& kits, const std::uint8_t* mask) {
  if (kits.empty()) return {};
  std::vector<StockPtr> next = stocks_;
  std::vector<env::Description> trials;
  for (std::size_t i = 0; i < size(); ++i) {
    if (kits[i] == nullptr || (mask != nullptr && mask[i] == 0)) continue;
    const auto same = [&](const StockPtr& stock) { return stock->kit == kits[i]; };
    const auto known = std::find_if(next.begin(), next.end(), same);
    if (known != next.end()) {
      next[i] = *known;
      continue;
    }
    next[i] = stock_of(kits[i]);
    trials.push_back(describe(*make_world(i, *next[i])));
    check_like_the_others(i, trials.back());
  }
  for (const env::Description& trial : trials) description_.widen(trial);
  return next;
}

void Batch::reset_world(std::size_t world, const env::KitPtr& kit, const std::uint64_t* seed, std::uint8_t* block) {
  StockPtr next;
  {
    const std::lock_guard lock(mutex_);
    next = stock_of(kit);
  }
  auto successor = make_world(world, *next);
  const env::Description own = describe(*successor);
  check_like_the_others(world, own);
  env::take_over(worlds_[world], std::move(successor), seed, block);
  description_.widen(own);
  const std::lock_guard lock(mutex_);
  stocks_[world] = std::move(next);
}

void Batch::step(const float* actions, const Output& output) {
  world(0).physics().require_undisturbed();
  perform(nullptr, Step(worlds_, options_, actions, output), output.status);
}

void Batch::send(const float* actions, const Output& output) {
  world(0).physics().require_undisturbed();
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
  world(0).physics().require_undisturbed();
  perform(mask, [&](std::size_t i, Report&) { worlds_[i]->observe(block_of(worlds_, blocks, i)); });
}

// Copying is so quick that waking threads for it would take longer.
void Batch::set(env::Quantity quantity, const env::Ids& ids, const std::uint8_t* mask, const double* values) {
  require_idle();
  const std::size_t width = env::width(world(0), quantity, ids);
  const auto row = [&](std::size_t i) { return Span<const double>(values + i * width, width); };
  for (std::size_t i = 0; i < size(); ++i) {  // all before any is changed
    if (mask != nullptr && mask[i] == 0) continue;
    env::check_settable(world(i), quantity, ids, row(i));
  }
  perform(mask, [&](std::size_t i, Report&) { env::set(*worlds_[i], quantity, ids, row(i)); });
}

std::size_t Batch::state_bytes() const {
  const auto shorter = [](const auto& a, const auto& b) { return a->state_bytes() < b->state_bytes(); };
  return (*std::max_element(worlds_.begin(), worlds_.end(), shorter))->state_bytes();
}

void Batch::save(const std::uint8_t* mask, std::uint8_t* states) {
  const std::size_t row = state_bytes();
  perform(mask, [&](std::size_t i, Report&) {
    const std::size_t bytes = worlds_[i]->state_bytes();
    std::uint8_t* own = states + i * row;
    worlds_[i]->save({own, bytes});
    std::fill(own + bytes, own + row, std::uint8_t{0});
  });
}

env::LoadReport Batch::load(const std::uint8_t* mask, Span<const std::uint8_t> states) {
  const bool shared = env::is_one_state(states);
  if (!shared && states.size() % size() != 0) {
    env::check_version(states);
    fail(Status::kInvalidArgument, "state_bytes is {}, expected those of one state, or a number that {} worlds share",
         states.size(), size());
  }
  const std::size_t row = shared ? states.size() : states.size() / size();
  const auto state_of = [&](std::size_t i) {
    try {
      return env::state_in(states.part(shared ? 0 : i * row, row));
    } catch (const Error& error) {
      fail(error.status(), "world {}: {}", i, error.message());
    }
  };
  for (std::size_t i = 0; i < size(); ++i) {  // rows that hold something else: before any world is changed
    if (mask == nullptr || mask[i] != 0) state_of(i);
  }
  std::fill(loaded_.begin(), loaded_.end(), env::LoadReport{});
  perform(mask, [&](std::size_t i, Report&) { loaded_[i] = worlds_[i]->load(state_of(i)); });
  const auto fewer = [](const env::LoadReport& a, const env::LoadReport& b) { return a.fresh < b.fresh; };
  return std::move(*std::max_element(loaded_.begin(), loaded_.end(), fewer));
}

void Batch::begin(const Operation& operation) {
  require_idle();
  operation_ = operation;
  busy_ = true;
}

void Batch::perform(const std::uint8_t* mask, Work work, std::int32_t* status) {
  begin({work, mask, status, workplace()});
  pool_.run(*this, size());
  finish();
}

void Batch::finish() {
  busy_ = false;
  for (Mailbox& mailbox : mailboxes_) mailbox.deliver();
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
  try {
    report.settled = false;
    operation_.work(world, report);
    if (!report.settled) report.note(Status::kOk, "");
  } catch (const Error& error) {
    report.note(error.status(), error.what());
  } catch (const std::bad_alloc&) {
    report.note(Status::kOutOfMemory, "out of memory");
  } catch (const std::exception& error) {
    report.note(Status::kInternal, error.what());
  } catch (...) {
    report.note(Status::kInternal, "an unknown exception");
  }
}

}  // namespace mimo::batch
