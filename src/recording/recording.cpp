#include "recording/recording.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/fail.h"
#include "env/state.h"
#include "recording/difference.h"
#include "recording/joints.h"

namespace mimo::recording {
namespace {

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
                {kBodies, h5.f64, 2}};
  for (const auto& [table, type, dimensions] : tables) {
    if (file.has(table)) file.require_table(table, type, dimensions);
  }
}

// A run that was killed may have lost more of one table than of another.
std::size_t whole_steps(const Reader& file) {
  std::size_t steps = std::min(file.rows(kTime), file.rows(kJointPosition));
  for (const char* table : {kJointVelocity, kActions, kRewards}) {
    if (file.has(table)) steps = std::min(steps, file.rows(table));
  }
  return steps;
}

}  // namespace

Recording::Recording(const std::string& path)
    : file_(path),
      configuration_(file_.text("configuration")),
      seed_(file_.text("seed")),
      build_(file_.text("build")),
      joint_names_(file_.text("joint_names")),
      step_seconds_(file_.real("step_seconds")) {
  if (!(step_seconds_ > 0 && std::isfinite(step_seconds_))) file_.damaged("'step_seconds' is no time");
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
    const State state{static_cast<std::size_t>(steps[i]), given[i] != 0, static_cast<std::size_t>(bodies[i])};
    if (has_bodies && state.body >= bodies_) break;  // was not flushed any more
    states_.push_back(state);
  }
}

void Recording::require_fitting(const env::World& world, bool compare_fields) const {
  require(joint_names(world) == joint_names_, "{} was recorded with other joints than those of env", file_.path());
  require(world.action_size() == actions_, "{} was recorded with {} actions, but env has {}", file_.path(), actions_,
          world.action_size());
  require(world.agents().size() == agents_, "{} was recorded with {} agents, but env has {}", file_.path(), agents_,
          world.agents().size());
  require(world.step_seconds() == step_seconds_, "{} was recorded with steps of {} s, but those of env last {} s",
          file_.path(), step_seconds_, world.step_seconds());
  if (!compare_fields) return;
  for (std::size_t i = 0; i < world.layout().size(); ++i) {
    const observation::Field& field = world.layout()[i];
    const std::string table = table_of(field);
    require(!file_.has(table) || file_.row_bytes(table) == field.bytes(),
            "compare_fields is 1, but {} has rows of another length in '{}' than env", file_.path(), table);
  }
}

std::size_t Recording::seek(blueprint::AgingWorld& target, std::size_t step, bool compare_fields) {
  require(step <= steps_, "step is {}, but {} ends at step {}", step, file_.path(), steps_);
  const auto later = [&](const State& state) { return state.step > step; };
  const auto end = std::find_if(states_.begin(), states_.end(), later);
  require(end != states_.begin(), "{} has no state to start from: it was cut off before its first flush", file_.path());
  require_fitting(target.world(), compare_fields);
  target.world().require_ready_to_reset();
  const std::size_t state = static_cast<std::size_t>(end - states_.begin()) - 1;
  target_ = nullptr;
  if (bodies_ == 0 || growths_of(target.world()) == growths_of_state(state)) {
    const std::uint64_t seed = 0;
    target.world().reset(&seed, nullptr);  // senses of other sizes begin fresh
  }
  enter(target, state);
  target_ = &target;
  compares_fields_ = compare_fields;
  next_ = states_[state].step;
  next_state_ = state + 1;
  verdict_ = {};
  return next_;
}

Growths Recording::growths_of_state(std::size_t state) const {
  try {
    require(file_.row_bytes(kBodies) == agents_ * growth_numbers() * sizeof(double),
            "a row has {} bytes, expected {} numbers for each of {} agents", file_.row_bytes(kBodies), growth_numbers(),
            agents_);
    const std::vector<std::uint8_t> bytes = file_.row(kBodies, states_[state].body);
    std::vector<double> row(bytes.size() / sizeof(double));
    std::memcpy(row.data(), bytes.data(), bytes.size());
    return growths_of_row(row);
  } catch (const Error& error) {
    file_.damaged("'bodies/growth': " + error.message());
  }
}

void Recording::enter(blueprint::AgingWorld& target, std::size_t state) {
  if (bodies_ != 0) target.grow(growths_of_state(state));
  const std::vector<std::uint8_t> row = file_.row(kStates, state);
  const Span<const std::uint8_t> bytes(row);
  target.world().load(env::state_in(bytes));
}

void Recording::play(blueprint::AgingWorld& target, std::uint8_t* block, const env::Results& results) {
  if (target_ == nullptr) fail(Status::kBusy, "recording has no replay: mimo_recording_seek begins one");
  require(target_ == &target, "env is not the world that mimo_recording_seek was given");
  if (next_ >= steps_) fail(Status::kNotFound, "{} ends at step {}", file_.path(), steps_);
  for (; next_state_ < states_.size() && states_[next_state_].step <= next_; ++next_state_) {
    if (states_[next_state_].changed) enter(target, next_state_);
  }
  env::World& world = target.world();
  action_.resize(actions_);
  if (actions_ > 0) {
    file_.read(kActions, next_, 1, {reinterpret_cast<std::uint8_t*>(action_.data()), actions_ * sizeof(float)});
  }
  const bool none = actions_ == 0 || std::isnan(action_[0]);
  const Span<const float> given = none ? Span<const float>() : Span<const float>(action_);
  if (block == nullptr && compares_fields_) {
    own_block_.resize(world.layout().bytes());
    block = own_block_.data();
  }
  world.check_actions(given);
  try {
    world.step(given, block, results);
  } catch (const Error& error) {
    if (error.status() == Status::kTask) go_on(world, block);  // the step has happened
    throw;
  }
  go_on(world, block);
}

void Recording::go_on(const env::World& world, const std::uint8_t* block) {
  compare(world, block);
  ++next_;
  ++verdict_.steps;
}

void Recording::compare(const env::World& world, const std::uint8_t* block) {
  const auto compare_numbers = [&](const char* table) {
    compare(table, observation::Type::kF64, numbers_.data(), numbers_.size() * sizeof(double));
  };
  read_joints(world, access::Quantity::kJointPosition, numbers_);
  compare_numbers(kJointPosition);
  read_joints(world, access::Quantity::kJointVelocity, numbers_);
  compare_numbers(kJointVelocity);
  numbers_.clear();
  for (const env::Agent& agent : world.agents()) numbers_.push_back(agent.task->reward());
  compare_numbers(kRewards);
  if (!compares_fields_) return;
  for (std::size_t i = 0; i < world.layout().size(); ++i) {
    const observation::Field& field = world.layout()[i];
    compare(table_of(field), field.type, block + field.offset, field.bytes());
  }
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
