#include "batch/batch.h"

#include <algorithm>
#include <new>

#include "base/fail.h"
#include "base/format.h"

namespace mimo::batch {

Batch::Batch(const engine::ModelPtr& model, const std::vector<env::AgentOptions>& agents, const OptionsOf& options_of,
             const Options& options)
    : options_(options),
      agents_(agents.size()),
      studio_(model, options_of(0), std::min(options.threads, options.worlds), this),
      reports_(options.worlds),
      pool_(std::min(options.threads, options.worlds)) {
  const env::EnvOptions first = options_of(0);
  if (env::sees(agents, first) && first.renderer != "none") studio_.furnish();
  mailboxes_.reserve(options.worlds);
  worlds_.reserve(options.worlds);
  std::vector<env::AgentOptions> shared;
  for (std::size_t i = 0; i < options.worlds; ++i) {
    env::EnvOptions own = options_of(i);
    mailboxes_.emplace_back(own.log, i, this);
    own.log = mailboxes_.back().slot();
    own.seed = i;  // worlds that nobody seeds are not all alike
    own.shared_renderer = &studio_;
    const auto& like_first = i == 0 ? agents : shared;
    worlds_.push_back(std::make_unique<env::World>(model, like_first, own));
    if (i == 0) shared = env::sharing(agents, worlds_[0]->agents());
  }
}

Batch::~Batch() {
  if (sent_) pool_.wait();
}

void Batch::require_idle() const {
  require(!busy_.load(std::memory_order_relaxed),
          "the batch is at work: only mimo_batch_receive can follow mimo_batch_send");
}

void Batch::require_access(std::size_t world) const {
  if (!busy_.load(std::memory_order_relaxed)) return;
  require(workplace().batch == this && workplace().world == world,
          "world {} belongs to a batch that is at work: mimo_batch_receive comes first", world);
}

bool Batch::works_on_this_thread() const { return works_for(this); }

void Batch::reset(const std::uint64_t* seeds, const std::uint8_t* mask, std::uint8_t* blocks) {
  world(0).physics().require_undisturbed();
  Call call;
  call.work = &Batch::reset_world;
  call.seeds = seeds;
  call.mask = mask;
  call.output.blocks = blocks;
  perform(call);
}

Batch::Call Batch::step_call(const float* actions, const Output& output) {
  Call call;
  call.work = &Batch::step_world;
  call.actions = actions;
  call.output = output;
  return call;
}

void Batch::step(const float* actions, const Output& output) {
  world(0).physics().require_undisturbed();
  perform(step_call(actions, output));
}

void Batch::send(const float* actions, const Output& output) {
  world(0).physics().require_undisturbed();
  begin(step_call(actions, output));
  try {
    pool_.start(*this, size());
  } catch (...) {  // no thread to be had
    busy_ = false;
    throw;
  }
  sent_ = true;
}

void Batch::receive() {
  require(!works_on_this_thread(), "a task cannot receive the step that it is part of: it would wait for itself");
  require(sent_, "mimo_batch_receive without mimo_batch_send");
  pool_.wait();
  sent_ = false;
  finish();
}

void Batch::observe(const std::uint8_t* mask, std::uint8_t* blocks) {
  world(0).physics().require_undisturbed();
  Call call;
  call.work = &Batch::observe_world;
  call.mask = mask;
  call.output.blocks = blocks;
  perform(call);
}

// Copying is so quick that waking threads for it would take longer.
void Batch::get(env::Quantity quantity, Span<const std::int32_t> ids, const std::uint8_t* mask, double* values) const {
  require_idle();
  const std::size_t width = env::width(world(0).model(), quantity, ids);
  for (std::size_t i = 0; i < size(); ++i) {
    if (mask != nullptr && mask[i] == 0) continue;
    env::get(world(i).physics(), quantity, ids, {values + i * width, width});
  }
}

void Batch::set(env::Quantity quantity, Span<const std::int32_t> ids, const std::uint8_t* mask, const double* values) {
  require_idle();
  Call call;
  call.work = &Batch::set_world;
  call.quantity = quantity;
  call.ids = ids;
  call.mask = mask;
  call.values = values;
  call.width = env::width(world(0).model(), quantity, ids);
  for (std::size_t i = 0; i < size(); ++i) {  // all before any is changed
    if (mask != nullptr && mask[i] == 0) continue;
    env::check_settable(world(i).model(), quantity, ids, {values + i * call.width, call.width});
  }
  perform(call);
}

// A name that the first world does not know, none does: nothing has changed then.
void Batch::set_face(std::size_t agent, const std::string& name, const std::uint8_t* mask) {
  require_idle();
  for (std::size_t i = 0; i < size(); ++i) {
    if (mask == nullptr || mask[i] != 0) world(i).set_face(agent, name);
  }
}

void Batch::save(const std::uint8_t* mask, std::uint8_t* states) {
  Call call;
  call.work = &Batch::save_world;
  call.mask = mask;
  call.saved = states;
  perform(call);
}

void Batch::load(const std::uint8_t* mask, const std::uint8_t* states, std::size_t stride) {
  Call call;
  call.work = &Batch::load_world;
  call.mask = mask;
  call.to_load = states;
  call.stride = stride;
  perform(call);
}

void Batch::begin(const Call& call) {
  require_idle();
  call_ = call;
  busy_ = true;
}

void Batch::perform(Call call) {
  call.caller = workplace();
  begin(call);
  pool_.run(*this, size());
  finish();
}

void Batch::finish() {
  busy_ = false;
  for (Mailbox& mailbox : mailboxes_) mailbox.deliver();
  std::size_t failures = 0, first = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!concerns(i) || reports_[i].status == Status::kOk || reports_[i].settled) continue;
    if (failures++ == 0) first = i;
  }
  if (failures == 0) return;
  const std::string others = failures == 1 ? "" : format(" (and {} more)", failures - 1);
  fail(reports_[first].status, "world {}{}: {}", first, others, reports_[first].message);
}

void Batch::run(std::size_t world, std::size_t thread) noexcept {
  if (!concerns(world)) return;
  const AtWork at({this, world, thread, &call_.caller});
  try {
    reports_[world].settled = false;
    (this->*call_.work)(world);
    if (!reports_[world].settled) note(world, Status::kOk, "");
  } catch (const Error& error) {
    note(world, error.status(), error.what());
  } catch (const std::bad_alloc&) {
    note(world, Status::kOutOfMemory, "out of memory");
  } catch (const std::exception& error) {
    note(world, Status::kInternal, error.what());
  } catch (...) {
    note(world, Status::kInternal, "an unknown exception");
  }
}

void Batch::note(std::size_t world, Status status, const char* message) noexcept {
  Report& report = reports_[world];
  report.status = status;
  try {
    report.message = message;
  } catch (...) {
    report.message.clear();
  }
  if (call_.output.status != nullptr) call_.output.status[world] = static_cast<std::int32_t>(status);
}

std::uint8_t* Batch::block(std::size_t world) const {
  std::uint8_t* first = call_.output.blocks;
  return first == nullptr ? nullptr : first + world * worlds_[world]->layout().bytes();
}

void Batch::reset_world(std::size_t world) {
  worlds_[world]->reset(call_.seeds == nullptr ? nullptr : call_.seeds + world, block(world));
}

void Batch::set_world(std::size_t world) {
  env::set(worlds_[world]->physics(), call_.quantity, call_.ids, {call_.values + world * call_.width, call_.width});
}

void Batch::save_world(std::size_t world) {
  const std::size_t bytes = worlds_[world]->state_bytes();
  worlds_[world]->save({call_.saved + world * bytes, bytes});
}

void Batch::load_world(std::size_t world) {
  worlds_[world]->load({call_.to_load + world * call_.stride, worlds_[world]->state_bytes()});
}

}  // namespace mimo::batch
