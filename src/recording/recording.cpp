#include "recording/recording.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "access/access.h"
#include "base/fail.h"
#include "document/composition.h"
#include "env/state.h"
#include "recording/rows.h"

namespace mimo::recording {
namespace {

constexpr std::pair<const char*, mimo_quantity> kJoints[] = {{kJointPosition, MIMO_JOINT_POSITION},
                                                             {kJointVelocity, MIMO_JOINT_VELOCITY}};

constexpr std::size_t kMostSceneBytes = std::size_t{1} << 30;

std::string table_of(const observation::Field& field) { return "fields/" + field.name; }

std::size_t row_bytes_of(const Reader& file, const char* table) { return file.has(table) ? file.row_bytes(table) : 0; }

// Throws where a table is not as the format has it.
void check_tables(const Reader& file) {
  const hdf5::Library& h5 = hdf5::library();
  const struct {
    const char* table;
    hdf5::Id type;
    std::size_t dimensions;
  } tables[] = {{kTime, h5.f64, 1},          {kActions, h5.f32, 2},       {kRewards, h5.f64, 2},
                {kJointPosition, h5.f64, 2}, {kJointVelocity, h5.f64, 2}, {kStates, h5.u8, 2},
                {kStateSteps, h5.i64, 1},    {kStateGiven, h5.u8, 1},     {kStateBodies, h5.i64, 1},
                {kBodies, h5.f64, 2},        {kModels, h5.u64, 1},        {kTerminated, h5.u8, 2},
                {kTruncated, h5.u8, 2},      {kOutcome, h5.i32, 2},       {kTerms, h5.f64, 2},
                {kDocuments, h5.u8, 2},      {kWorld, h5.u8, 1}};
  for (const auto& [table, type, dimensions] : tables) {
    if (file.has(table)) file.require_table(table, type, dimensions);
  }
}

// A run that was killed may have lost more of one table than of another.
std::size_t whole_steps(const Reader& file) {
  std::size_t steps = std::min(file.rows(kTime), file.rows(kJointPosition));
  for (const char* table : {kJointVelocity, kActions, kRewards, kTerminated, kTruncated, kOutcome, kTerms}) {
    if (file.has(table)) steps = std::min(steps, file.rows(table));
  }
  return steps;
}

// Names of fields.
std::set<std::string> told_by_tasks(const env::World& world) {
  std::set<std::string> names;
  for (const env::Agent& agent : world.agents()) {
    const std::string prefix = agent.name.empty() ? "" : agent.name + "/";
    for (const observation::Signal& signal : agent.task->signals(world.model())) {
      names.insert(prefix + signal.field.name);
    }
  }
  return names;
}

// States are kept as they lie in memory, and so of machines of one kind.
void require_byte_order(const Reader& file) {
  const std::string order = file.text("byte_order");
  if (order != byte_order())
    fail(Status::kMismatch, "{} has states in the byte order {}, which this machine does not use", file.path(), order);
}

}  // namespace

Recording::Recording(const std::string& path)
    : file_(path),
      configuration_(file_.text("configuration")),
      seed_(file_.text("seed")),
      build_(file_.text("build")),
      joint_names_(file_.text("joint_names")),
      step_seconds_(file_.real("step_seconds")) {
  if (file_.integer("format_version") >= 3) {
    library_ = file_.text("library");
    mujoco_ = file_.text("mujoco");
    require_byte_order(file_);
  }
  if (!(step_seconds_ > 0 && std::isfinite(step_seconds_))) file_.damaged("'step_seconds' is not a time");
  check_tables(file_);
  steps_ = whole_steps(file_);
  actions_ = row_bytes_of(file_, kActions) / sizeof(float);
  agents_ = row_bytes_of(file_, kRewards) / sizeof(double);
  if (file_.has(kBodies)) bodies_ = file_.rows(kBodies);
  read_states();
}

void Recording::read_states() {
  const bool marked = file_.integer("format_version") >= 2;
  std::size_t count = std::min(file_.rows(kStateSteps), file_.rows(kStates));
  if (marked) count = std::min({count, file_.rows(kStateGiven), file_.rows(kStateBodies)});
  if (count > file_.bytes()) file_.damaged("it has more states than bytes");
  const auto steps = file_.numbers<std::int64_t>(kStateSteps, 0, count);
  std::vector<std::uint8_t> given(count);
  std::vector<std::int64_t> bodies(count);
  if (marked) {
    given = file_.numbers<std::uint8_t>(kStateGiven, 0, count);
    bodies = file_.numbers<std::int64_t>(kStateBodies, 0, count);
  }
  const bool has_bodies = file_.has(kBodies);
  for (std::size_t i = 0; i < count; ++i) {
    if (steps[i] < (i > 0 ? steps[i - 1] : 0)) file_.damaged("'states/step' is not in order");
    if (bodies[i] < 0) file_.damaged("'states/body' is negative");
    const State state{static_cast<std::size_t>(steps[i]), given[i] != kReached, given[i] == kMoves,
                      static_cast<std::size_t>(bodies[i])};
    if (has_bodies && state.body >= bodies_) break;  // was not flushed any more
    states_.push_back(state);
  }
}

std::string Recording::world() const {
  if (file_.has(kWorld) && file_.has(kDocuments)) return file_.content(kWorld);
  fail(Status::kUnsupported,
       "{} has format version {}, which does not contain the world ('{}' and '{}'); make the world yourself",
       file_.path(), file_.integer("format_version"), kWorld, kDocuments);
}

scene::Source Recording::scene_of(std::size_t body) const {
  std::vector<std::uint8_t> row = file_.row(kDocuments, body);
  row.erase(std::find(row.begin(), row.end(), std::uint8_t{0}), row.end());
  scene::Source source;
  source.xml.assign(row.begin(), row.end());
  auto files = std::make_shared<document::Files>();
  std::size_t bytes = 0;
  for (const std::string& name : document::files_named_by(source.xml)) {
    if (files->count(name) != 0 || !file_.has_dataset(kSceneFolder + name))
      continue;  // about which the scene complains
    bytes += file_.rows(kSceneFolder + name);
    if (bytes > kMostSceneBytes)
      file_.damaged("its scene has files of more than " + std::to_string(kMostSceneBytes) + " bytes");
    files->emplace(name, file_.content(kSceneFolder + name));
  }
  source.limits.files = std::move(files);
  return source;
}

scene::Source Recording::scene(const Growths& growths) const {
  for (std::size_t body = 0; body < bodies_; ++body) {
    if (growths_of_body(body) == growths) return scene_of(body);
  }
  fail(Status::kUnsupported, "growth: {} holds its scene with infants of {} ages, and this is not one of them",
       file_.path(), bodies_);
}

// A state would be refused as well, but could not tell why.
void Recording::require_same_model(const env::World& world, std::size_t body) const {
  if (!file_.has(kModels) || body >= file_.rows(kModels)) return;
  const std::uint64_t recorded = file_.numbers<std::uint64_t>(kModels, body, 1)[0];
  if (recorded == world.model_hash()) return;
  fail(Status::kMismatch,
       "{} was recorded with another model: its hash is {:016x} with libmimo {} and MuJoCo {}, and that of env is "
       "{:016x}; "
       "a replay by joints works with any model",
       file_.path(), recorded, library_, mujoco_, world.model_hash());
}

void Recording::require_fitting(const env::World& world, bool compare_fields) const {
  const auto expect = [](bool alike, const char* what, const auto&... values) {
    if (!alike) fail(Status::kMismatch, what, values...);
  };
  expect(joint_names(world) == joint_names_, "{} was recorded with joints that differ from those of env", file_.path());
  expect(world.action_size() == actions_, "{} was recorded with {} actions, but env has {}", file_.path(), actions_,
         world.action_size());
  expect(world.agents().size() == agents_, "{} was recorded with {} agents, but env has {}", file_.path(), agents_,
         world.agents().size());
  expect(world.step_seconds() == step_seconds_, "{} was recorded with steps of {} s, but those of env last {} s",
         file_.path(), step_seconds_, world.step_seconds());
  if (!compare_fields) return;
  for (std::size_t i = 0; i < world.layout().size(); ++i) {
    const observation::Field& field = world.layout()[i];
    const std::string table = table_of(field);
    expect(!file_.has(table) || file_.row_bytes(table) == field.bytes(),
           "compare_fields is 1, but {} has rows in '{}' whose length differs from that of env's field", file_.path(),
           table);
  }
}

std::size_t Recording::seek(blueprint::AgingWorld& target, std::size_t step, const Play& how) {
  require(step <= steps_, "step is {}, but {} ends at step {}", step, file_.path(), steps_);
  const auto later = [&](const State& state) { return state.step > step; };
  const auto end = std::find_if(states_.begin(), states_.end(), later);
  require(end != states_.begin(), "{} has no state to start from: recording stopped before the first flush",
          file_.path());
  require_fitting(target.world(), how.compares_fields);
  target.world().require_ready_to_reset();
  const std::size_t state = static_cast<std::size_t>(end - states_.begin()) - 1;
  target_ = nullptr;
  if (bodies_ == 0 || growths_of(target.world()) == growths_of_state(state)) {
    const std::uint64_t seed = 0;
    target.world().reset(&seed, nullptr);  // senses of other sizes begin fresh
  }
  how_ = how;
  untold_ = how.has_no_task ? told_by_tasks(target.world()) : std::set<std::string>();
  enter(target, state);
  target_ = &target;
  next_ = states_[state].step;
  next_state_ = state + 1;
  verdict_ = {};
  return next_;
}

Growths Recording::growths_of_body(std::size_t body) const {
  try {
    require(file_.row_bytes(kBodies) == agents_ * growth::kMembers * sizeof(double),
            "a row has {} bytes, expected {} numbers for each of {} agents", file_.row_bytes(kBodies), growth::kMembers,
            agents_);
    const std::vector<std::uint8_t> bytes = file_.row(kBodies, body);
    std::vector<double> row(bytes.size() / sizeof(double));
    std::memcpy(row.data(), bytes.data(), bytes.size());
    return growths_of_row(row);
  } catch (const Error& error) {
    file_.damaged("'bodies/growth': " + error.message());
  }
}

void Recording::enter(blueprint::AgingWorld& target, std::size_t state) {
  if (bodies_ != 0) target.grow(growths_of_state(state));
  if (how_.by_joints) return;
  if (states_[state].moves) {
    fail(Status::kMismatch, "{}: its steps from {} on follow a known movement; a replay by joints plays them",
         file_.path(), states_[state].step);
  }
  require_same_model(target.world(), states_[state].body);
  const std::vector<std::uint8_t> row = file_.row(kStates, state);
  const Span<const std::uint8_t> bytes(row);
  target.world().load(env::state_in(bytes));
}

// What a step made of the joints, without the step.
void Recording::put_joints(env::World& world, std::uint8_t* block) {
  for (const auto& [table, quantity] : kJoints) {
    if (!file_.has(table)) continue;
    read_joints(world, quantity, numbers_);
    const std::size_t bytes = numbers_.size() * sizeof(double);
    if (file_.row_bytes(table) != bytes) file_.damaged("'" + std::string(table) + "' has rows of another length");
    file_.read(table, next_, 1, {reinterpret_cast<std::uint8_t*>(numbers_.data()), bytes});
    try {
      access::set(world, access::quantity_of(quantity), access::Ids(world.model().njnt), Span<const double>(numbers_));
    } catch (const Error& error) {
      if (error.status() != Status::kInvalidArgument) throw;
      file_.damaged("'" + std::string(table) + "': " + error.message());
    }
  }
  world.observe(block);
}

// Those that were recorded.
void Recording::give_results(const env::Results& results) {
  const auto give = [this](const char* table, auto values) {
    const std::size_t bytes = values.size() * sizeof(*values.data());
    if (bytes == 0 || !file_.has(table)) return;
    if (file_.row_bytes(table) != bytes) file_.damaged("'" + std::string(table) + "' has rows of another length");
    file_.read(table, next_, 1, {reinterpret_cast<std::uint8_t*>(values.data()), bytes});
  };
  give(kRewards, results.reward);
  give(kTerminated, results.terminated);
  give(kTruncated, results.truncated);
  give(kOutcome, results.outcome);
  give(kTerms, results.terms);
}

void Recording::play(blueprint::AgingWorld& target, std::uint8_t* block, const env::Results& results) {
  if (target_ == nullptr) fail(Status::kBusy, "no replay has begun: call mimo_recording_seek first");
  require(target_ == &target, "env is not the world that was passed to mimo_recording_seek");
  if (next_ >= steps_) fail(Status::kEnd, "{} ends at step {}", file_.path(), steps_);
  for (; next_state_ < states_.size() && states_[next_state_].step <= next_; ++next_state_) {
    if (states_[next_state_].changed) enter(target, next_state_);
  }
  env::World& world = target.world();
  if (block == nullptr && how_.compares_fields) {
    own_block_.resize(world.layout().bytes());
    block = own_block_.data();
  }
  how_.by_joints ? put_joints(world, block) : act(world, block, results);
  if (how_.by_joints || how_.has_no_task) give_results(results);
  go_on(world, block);
}

void Recording::act(env::World& world, std::uint8_t* block, const env::Results& results) {
  action_.resize(actions_);
  if (actions_ > 0) {
    file_.read(kActions, next_, 1, {reinterpret_cast<std::uint8_t*>(action_.data()), actions_ * sizeof(float)});
  }
  const bool none = actions_ == 0 || std::isnan(action_[0]);
  const Span<const float> given = none ? Span<const float>() : Span<const float>(action_);
  world.check_actions(given);
  try {
    world.step(given, block, results);
  } catch (const Error& error) {
    if (error.status() == Status::kTask) go_on(world, block);  // the step has happened
    throw;
  }
}

void Recording::go_on(const env::World& world, const std::uint8_t* block) {
  compare(world, block);
  ++next_;
  ++verdict_.steps;
}

void Recording::compare(const env::World& world, const std::uint8_t* block) {
  if (!how_.by_joints) compare_joints(world);
  if (!how_.by_joints && !how_.has_no_task) compare_results(world);
  if (!how_.compares_fields) return;
  for (std::size_t i = 0; i < world.layout().size(); ++i) {
    const observation::Field& field = world.layout()[i];
    if (untold_.count(field.name) != 0) continue;
    compare(table_of(field), field.type, block + field.offset, field.bytes());
  }
}

void Recording::compare_joints(const env::World& world) {
  for (const auto& [table, quantity] : kJoints) {
    read_joints(world, quantity, numbers_);
    compare(table, observation::Type::kF64, numbers_.data(), numbers_.size() * sizeof(double));
  }
}

void Recording::compare_results(const env::World& world) {
  const auto compare_all = [this](const char* table, observation::Type type, const auto& values) {
    compare(table, type, values.data(), values.size() * sizeof values[0]);
  };
  results_.take(world);
  compare_all(kRewards, observation::Type::kF64, results_.reward);
  compare_all(kTerminated, observation::Type::kU8, results_.terminated);
  compare_all(kTruncated, observation::Type::kU8, results_.truncated);
  compare_all(kOutcome, observation::Type::kI32, results_.outcome);
  compare_all(kTerms, observation::Type::kF64, results_.terms);
}

void Recording::compare(const std::string& table, observation::Type type, const void* now, std::size_t bytes) {
  if (bytes == 0 || !file_.has(table) || next_ >= file_.rows(table)) return;
  if (file_.row_bytes(table) != bytes) file_.damaged("'" + table + "' has rows of another length");
  row_.resize(bytes);
  file_.read(table, next_, 1, row_);
  if (std::memcmp(row_.data(), now, bytes) == 0) return;
  if (verdict_.identical) verdict_.first = next_;
  verdict_.identical = false;
  const double difference = largest_difference(type, row_, {static_cast<const std::uint8_t*>(now), bytes});
  if (difference < verdict_.largest) return;
  verdict_.largest = difference;
  verdict_.table = table;
}

}  // namespace mimo::recording
