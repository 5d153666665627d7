#include "recording/recorder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

#include "base/fail.h"
#include "base/format.h"
#include "env/description.h"
#include "recording/rows.h"

namespace mimo::recording {
namespace {

constexpr std::size_t kMostNamed = 1000;  // elements of a field that are listed by name

// "touch" fits "touch/force" and "anna/touch/force".
bool fits(const std::string& name, const std::string& word) {
  return ("/" + name + "/").find("/" + word + "/") != std::string::npos;
}

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    words.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

[[noreturn]] void fail_unknown(const observation::Layout& layout, const std::string& word) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < layout.size(); ++i) names.push_back(layout[i].name);
  fail(Status::kNotFound, "keep: this world has no sense or field \"{}\"; fields are: {}", word,
       some_of(std::move(names)));
}

// Numbers of fields.
std::vector<std::size_t> choose(const observation::Layout& layout, const std::string& keep) {
  const bool usual = keep.empty();
  const auto words = words_of(usual ? "proprioception,vestibular" : keep == "none" ? "" : keep);
  std::vector<std::size_t> chosen;
  for (const std::string& word : words) {
    const auto wanted = [&](std::size_t i) { return word == "all" || fits(layout[i].name, word); };
    const std::size_t before = chosen.size();
    for (std::size_t i = 0; i < layout.size(); ++i) {
      if (wanted(i)) chosen.push_back(i);
    }
    if (chosen.size() == before && !usual && keep != "none" && word != "all") fail_unknown(layout, word);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

hdf5::Id type_of(observation::Type type) {
  const hdf5::Library& h5 = hdf5::library();
  switch (type) {
    case observation::Type::kU8: return h5.u8;
    case observation::Type::kI32: return h5.i32;
    case observation::Type::kF32: return h5.f32;
    case observation::Type::kF64: return h5.f64;
  }
  return h5.u8;
}

std::string labels_of(const observation::Field& field) {
  if (field.labels.empty() || field.count() > kMostNamed) return "";
  std::string names;
  for (std::size_t i = 0; i < field.count(); ++i) names += std::string(field.label(i)) + "\n";
  return names;
}

std::string action_names(const env::World& world) {
  std::string names;
  for (const env::Action& action : env::describe(world).actions) names += action.name + "\n";
  return names;
}

Span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// A world that has failed has none.
void save(const env::World& world, std::vector<std::uint8_t>& state) {
  state.resize(world.state_bytes());
  world.save(Span<std::uint8_t>(state));
}

}  // namespace

std::shared_ptr<Recorder> Recorder::follow(const blueprint::AgingWorld& aging, const Options& options) {
  env::World& world = aging.world();
  if (world.in_task()) fail(Status::kBusy, "env is inside a step or reset; a recording can only start between them");
  if (world.step_observer() != nullptr) fail(Status::kBusy, "env is being recorded already");
  std::shared_ptr<Recorder> recorder(new Recorder(aging, options));
  world.tell(recorder);
  return recorder;
}

Recorder::Recorder(const blueprint::AgingWorld& aging, const Options& options)
    : worlds_(aging.worlds()),
      world_(&aging.world()),
      state_every_(static_cast<std::size_t>(std::max(1.0, std::round(options.state_seconds / world_->step_seconds())))),
      step_seconds_(world_->step_seconds()),
      flush_seconds_(options.flush_seconds),
      own_task_(worlds_->as_described().task != nullptr),
      body_(growths_of(*world_)) {
  const env::World& world = *world_;
  const std::vector<std::size_t> kept = choose(world.layout(), options.keep);
  save(world, state_);
  const document::Package package = worlds_->described_at(body_).scene.package();
  file_ = std::make_unique<Writer>(options.path, options.replace, options.compression, package.bytes());
  describe(world, options);
  describe_results(world);
  describe_fields(world, kept);
  describe_world(package);
  file_->start();
  keep_body(world, package.document);
}

void Recorder::describe(const env::World& world, const Options& options) {
  const hdf5::Library& h5 = hdf5::library();
  file_->attribute("format", std::string(kFormat));
  file_->attribute("format_version", kVersion);
  file_->attribute("build", options.build);
  file_->attribute("library", options.library);
  file_->attribute("mujoco", options.mujoco);
  file_->attribute("byte_order", std::string(byte_order()));
  file_->attribute("configuration", options.configuration);
  file_->attribute("seed", options.seed);
  file_->attribute("step_seconds", step_seconds_);
  file_->attribute("joint_names", joint_names(world));
  file_->table(kTime, h5.f64, {}, "s");
  file_->table(kActions, h5.f32, {world.action_size()}, "", action_names(world));
  for (const auto& [table, quantity, unit] : {std::tuple(kJointPosition, MIMO_JOINT_POSITION, "m or rad"),
                                              std::tuple(kJointVelocity, MIMO_JOINT_VELOCITY, "m/s or rad/s")}) {
    read_joints(world, quantity, numbers_);
    file_->table(table, h5.f64, {numbers_.size()}, unit, joint_columns(world, quantity));
  }
  file_->table(kStates, h5.u8, {state_.size()}, "", "", Writer::Rows::kMayGrow);
  file_->table(kStateSteps, h5.i64, {}, "");
  file_->table(kStateGiven, h5.u8, {}, "");
  file_->table(kStateBodies, h5.i64, {}, "");
}

void Recorder::describe_results(const env::World& world) {
  const hdf5::Library& h5 = hdf5::library();
  const std::size_t agents = world.agents().size();
  std::string terms;
  for (const env::RewardTerm& term : env::describe(world).terms) terms += term.name + "\n";
  file_->table(kRewards, h5.f64, {agents}, "");
  file_->table(kTerminated, h5.u8, {agents}, "");
  file_->table(kTruncated, h5.u8, {agents}, "");
  file_->table(kOutcome, h5.i32, {agents}, "");
  file_->table(kTerms, h5.f64, {world.term_count()}, "", terms);
}

// What it takes to make the world again: its document for each age of its infants, all files that this refers to, and
// the calls that made the rest.
void Recorder::describe_world(const document::Package& package) {
  const hdf5::Library& h5 = hdf5::library();
  std::string calls;
  for (const std::string& call : worlds_->as_described().calls) calls += (calls.empty() ? "[\n" : ",\n") + call;
  file_->content(kWorld, bytes_of(calls.empty() ? "[]" : calls += "\n]"));
  for (const auto& [name, bytes] : package.files) file_->content(kSceneFolder + name, bytes_of(bytes));
  file_->table(kDocuments, h5.u8, {package.document.size()}, "", "", Writer::Rows::kMayGrow);
  file_->table(kModels, h5.u64, {}, "");
  file_->table(kBodies, h5.f64, {row_of(body_).size()}, "", names_of_row(*world_));
}

void Recorder::keep_body(const env::World& world, const std::string& document) {
  const std::vector<double> row = row_of(body_);
  const std::uint64_t hash = world.model_hash();
  file_->append(kBodies, row.data());
  file_->append(kDocuments, bytes_of(document));
  file_->append(kModels, &hash);
}

void Recorder::describe_fields(const env::World& world, const std::vector<std::size_t>& kept) {
  for (const std::size_t i : kept) {
    const observation::Field& field = world.layout()[i];
    fields_.push_back({"fields/" + field.name, field.offset});
    file_->table(fields_.back().table, type_of(field.type), field.shape, field.unit, labels_of(field));
  }
  if (!fields_.empty()) own_block_.resize(world.layout().bytes());
}

// What fails here must not fail the step.
template <typename Work>
void Recorder::attempt(Work&& work) noexcept {
  if (file_ == nullptr) return;
  try {
    work();
  } catch (const std::exception& error) {
    try {
      trouble_ = error.what();
    } catch (...) {
      trouble_ = "no memory";  // short enough to need none
    }
    file_.reset();
  }
}

std::uint8_t* Recorder::step_begins(const env::World& world, std::uint8_t* block) noexcept {
  return begins(world, block, false);
}

std::uint8_t* Recorder::movement_begins(const env::World& world, std::uint8_t* block) noexcept {
  return begins(world, block, true);
}

std::uint8_t* Recorder::begins(const env::World& world, std::uint8_t* block, bool moved) noexcept {
  const std::lock_guard alone(mutex_);
  stepping_ = true;
  attempt([&] { begin(world, moved); });
  if (own_task_) changes_ = world.changes();  // what the task does to the world in this step is a change, too
  return block == nullptr && !own_block_.empty() ? own_block_.data() : block;
}

void Recorder::begin(const env::World& world, bool moved) {
  const bool anew = changed(world) || moved != moved_;
  moved_ = moved;
  const StateMark mark = moved ? kMoves : anew ? kGiven : kReached;
  if (anew || static_cast<std::size_t>(steps_) % state_every_ == 0) keep_state(world, mark);
  if (!begun_) begun_ = file_->flush_if_free();  // from here on a run that is killed can be replayed
}

bool Recorder::changed(const env::World& world) const { return steps_ > 0 && world.changes() != changes_; }

void Recorder::keep_state(const env::World& world, StateMark mark) {
  save(world, state_);
  Growths body = growths_of(world);
  if (body != body_) {
    body_ = std::move(body);
    keep_body(world, worlds_->described_at(body_).scene.package().document);
    ++bodies_;
  }
  file_->append(kStates, Span<const std::uint8_t>(state_));
  file_->append(kStateSteps, &steps_);
  const std::uint8_t number = mark;
  file_->append(kStateGiven, &number);
  file_->append(kStateBodies, &bodies_);
}

void Recorder::step_ends(env::World& world, Span<const float> actions, const std::uint8_t* block) noexcept {
  bool complains = false;
  {
    const std::lock_guard alone(mutex_);
    attempt([&] { write(world, actions, block); });
    if (!own_task_) changes_ = world.changes();
    stepping_ = false;
    complains = !trouble_.empty() && !told_;
    told_ = told_ || complains;
  }
  if (complains) complain(world);  // without the lock: the callback may call flush()
}

void Recorder::write(const env::World& world, Span<const float> actions, const std::uint8_t* block) {
  const double time = step_seconds_ * static_cast<double>(++steps_);
  file_->append(kTime, &time);
  // A step without actions leaves the motors as they are, which no action does.
  actions_.assign(world.action_size(), std::numeric_limits<float>::quiet_NaN());
  std::copy(actions.begin(), actions.end(), actions_.begin());
  file_->append(kActions, actions_.data());
  write_results(world);
  read_joints(world, MIMO_JOINT_POSITION, numbers_);
  file_->append(kJointPosition, numbers_.data());
  read_joints(world, MIMO_JOINT_VELOCITY, numbers_);
  file_->append(kJointVelocity, numbers_.data());
  for (const Kept& field : fields_) file_->append(field.table, block + field.offset);
  if (std::chrono::duration<double>(Clock::now() - flushed_).count() < flush_seconds_) return;
  if (file_->flush_if_free()) flushed_ = Clock::now();
}

void Recorder::write_results(const env::World& world) {
  results_.take(world);
  file_->append(kRewards, results_.reward.data());
  file_->append(kTerminated, results_.terminated.data());
  file_->append(kTruncated, results_.truncated.data());
  file_->append(kOutcome, results_.outcome.data());
  file_->append(kTerms, results_.terms.data());
}

void Recorder::complain(const env::World& world) const {
  try {
    world.warn("the recording has ended: " + trouble_);
  } catch (...) {
  }
}

void Recorder::step_failed() noexcept {
  const std::lock_guard alone(mutex_);
  stepping_ = false;
}

void Recorder::goes_on_in(env::World& world) noexcept {
  const std::lock_guard alone(mutex_);
  world_ = &world;
}

void Recorder::ends(const env::World&) noexcept {
  const std::lock_guard alone(mutex_);
  finish();
  world_ = nullptr;
}

// The last state, if the world has one, and the file is closed.
void Recorder::finish() noexcept {
  attempt([&] {
    const env::World& world = *world_;
    if (!world.physics().failed()) keep_state(world, changed(world) ? kGiven : kReached);
    file_->close();
  });
  file_.reset();
}

void Recorder::flush() {
  const std::lock_guard alone(mutex_);
  attempt([&] { file_->flush(); });
  require_whole();
}

void Recorder::require_whole() const {
  if (!trouble_.empty()) fail(Status::kFile, "{}", trouble_);
}

void Recorder::close() {
  const std::lock_guard alone(mutex_);
  if (stepping_) fail(Status::kBusy, "recorder cannot be closed inside a step of its world");
  if (world_ != nullptr) {
    finish();
    world_->tell(nullptr);
    world_ = nullptr;
  }
}

}  // namespace mimo::recording
