#include "fmi/unit.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "programs/files.h"
#include "programs/program.h"

namespace cli {
namespace {

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file = open_to_read(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

// The options that the unit was written with. Its scene, if it is a file, lies beside.
UnitOptions options_of(const std::string& resources, std::vector<std::string> words) {
  UnitOptions options;
  CLI::App app("a unit of FMI");
  add_scene_options(app, options.world);
  add_actuation_option(app, options.world);
  add_face_option(app, options.world);
  add_seed_option(app, options.world);
  add_unit_options(app, options);
  std::reverse(words.begin(), words.end());
  app.parse(words);
  if (options.world.scene.find('/') != std::string::npos) options.world.scene = resources + '/' + options.world.scene;
  return options;
}

template <typename T>
void put(Bytes& bytes, const T* values, std::size_t count) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(values);
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

// Reads what `put` wrote.
class Reader {
 public:
  explicit Reader(const Bytes& bytes) : bytes_(bytes) {}

  template <typename T>
  void take(T* values, std::size_t count) {
    if (bytes_.size() - at_ < count * sizeof(T)) throw Failure("the state is too short");
    if (count != 0) std::memcpy(values, bytes_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
  }
  Bytes rest() const { return Bytes(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), bytes_.end()); }

 private:
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

constexpr char kStateMark[8] = {'m', 'i', 'm', 'o', 'f', 'm', 'i', '1'};

}  // namespace

RunningUnit::RunningUnit(const std::string& resources, const std::string& token) {
  std::vector<std::string> words = lines_of(resources + '/' + kUnitArguments);
  if (words.empty() || words[0] != token) {
    throw Failure("the token is '" + token + "', expected '" + (words.empty() ? "" : words[0]) + "' of this unit");
  }
  words.erase(words.begin());
  options_ = options_of(resources, words);
  env_ = open_unit_world(options_);
  variables_ = variables_of(env_, options_);
  block_ = env_.make_block();
  results_ = env_.make_results();
  for (const mimo_action& it : env_.layout().actions()) {
    rest_.push_back(static_cast<float>(std::clamp(0.0, it.low, it.high)));
  }
  actions_ = rest_;
  step_ = env_.timestep() * env_.frame_skip();
  seed_ = options_.world.seed;
}

void RunningUnit::begin() {
  if (fresh_) return;
  env_.reset(seed_, block_);
  results_ = env_.make_results();
  fresh_ = true;
}

void RunningUnit::initialize(double start_time) {
  if (mode_ != kMade) throw Failure("the unit is initialized already; reset it first");
  if (!std::isfinite(start_time)) throw Failure("startTime is not finite");
  time_ = start_time;
  begin();
  mode_ = kInitializing;
}

void RunningUnit::start() {
  if (mode_ != kInitializing) throw Failure("the unit is not in initialization mode");
  begin();
  mode_ = kStepping;
}

void RunningUnit::step(double time, double seconds) {
  if (mode_ != kStepping) throw Failure("a step before initialization has ended, or after the unit was terminated");
  const double tolerance = 1e-6 * step_;
  if (!(std::abs(time - time_) <= tolerance)) {
    throw Failure(text("currentCommunicationPoint is %.9g s, expected %.9g s, where the unit is", time, time_));
  }
  const double count = std::round(seconds / step_);
  if (!(count >= 1 && count <= 1e9 && std::abs(seconds - count * step_) <= tolerance * count)) {
    throw Failure(text("communicationStepSize is %.9g s, expected a multiple of the step of %.9g s", seconds, step_));
  }
  fresh_ = false;
  for (double i = 0; i < count; ++i) env_.step(actions_, block_, results_);
  time_ += count * step_;
}

void RunningUnit::reset() {
  mode_ = kMade;
  fresh_ = false;
  actions_ = rest_;
  seed_ = options_.world.seed;
}

const Variable& RunningUnit::variable(std::uint32_t number, const char* type, int version) const {
  if (version != options_.version) throw Failure("the unit is one of FMI " + std::to_string(options_.version));
  if (number >= variables_.size()) {
    throw Failure("valueReference is " + std::to_string(number) + ", expected less than " +
                  std::to_string(variables_.size()));
  }
  const Variable& it = variables_[number];
  if (std::strcmp(it.type(version), type) != 0) {
    throw Failure(it.name + " is a variable of type " + it.type(version) + ", not " + type);
  }
  if (it.is_output() && mode_ == kMade) throw Failure(it.name + " is known from initialization mode on");
  return it;
}

template <typename T>
void RunningUnit::get(const Variable& it, T* values) const {
  const auto copy = [&](auto sample) {
    for (std::size_t i = 0; i < it.count; ++i) {
      std::memcpy(&sample, block_.data() + it.place + i * sizeof sample, sizeof sample);
      values[i] = static_cast<T>(sample);
    }
  };
  switch (it.kind) {
    case Variable::kTime: *values = static_cast<T>(time_); return;
    case Variable::kSeed: *values = static_cast<T>(seed_); return;
    case Variable::kAction: *values = static_cast<T>(actions_[it.place]); return;
    case Variable::kReward: *values = static_cast<T>(results_.reward[it.place]); return;
    case Variable::kTerminated: *values = static_cast<T>(results_.terminated[it.place]); return;
    case Variable::kTruncated: *values = static_cast<T>(results_.truncated[it.place]); return;
    case Variable::kField:
    case Variable::kPicture: break;
  }
  if (it.dtype == MIMO_F32) copy(float{});
  if (it.dtype == MIMO_F64) copy(double{});
  if (it.dtype == MIMO_I32) copy(std::int32_t{});
  if (it.dtype == MIMO_U8) copy(std::uint8_t{});
}

template void RunningUnit::get(const Variable&, double*) const;
template void RunningUnit::get(const Variable&, float*) const;
template void RunningUnit::get(const Variable&, std::int32_t*) const;
template void RunningUnit::get(const Variable&, std::uint8_t*) const;
template void RunningUnit::get(const Variable&, std::uint64_t*) const;

void RunningUnit::set_action(const Variable& it, double value) {
  if (!it.is_input()) throw Failure(it.name + " is no input");
  if (!std::isfinite(value)) throw Failure(it.name + " is not finite");
  actions_[it.place] = static_cast<float>(value);
}

void RunningUnit::set_seed(std::uint64_t seed) {
  if (mode_ > kInitializing) throw Failure("seed is set before the unit is initialized, or in initialization mode");
  if (seed == seed_) return;
  seed_ = seed;
  fresh_ = false;
}

Bytes RunningUnit::save() const {
  if (mode_ == kMade) throw Failure("the unit has no state before initialization mode");
  Bytes bytes;
  put(bytes, kStateMark, sizeof kStateMark);
  put(bytes, &time_, 1);
  put(bytes, &seed_, 1);
  const std::uint8_t mode = mode_, fresh = fresh_;
  put(bytes, &mode, 1);
  put(bytes, &fresh, 1);
  put(bytes, actions_.data(), actions_.size());
  put(bytes, results_.reward.data(), results_.reward.size());
  put(bytes, results_.terminated.data(), results_.terminated.size());
  put(bytes, results_.truncated.data(), results_.truncated.size());
  put(bytes, block_.data(), block_.bytes());
  const Bytes world = env_.save();
  bytes.insert(bytes.end(), world.begin(), world.end());
  return bytes;
}

void RunningUnit::load(const Bytes& state) {
  Reader reader(state);
  char mark[sizeof kStateMark];
  double time = 0;
  std::uint64_t seed = 0;
  std::uint8_t mode = 0, fresh = 0;
  reader.take(mark, sizeof mark);
  if (std::memcmp(mark, kStateMark, sizeof mark) != 0) throw Failure("the bytes are no state of a unit");
  reader.take(&time, 1);
  reader.take(&seed, 1);
  reader.take(&mode, 1);
  reader.take(&fresh, 1);
  std::vector<float> actions(actions_.size());
  mimo::Results results = env_.make_results();
  mimo::Block block = env_.make_block();
  reader.take(actions.data(), actions.size());
  reader.take(results.reward.data(), results.reward.size());
  reader.take(results.terminated.data(), results.terminated.size());
  reader.take(results.truncated.data(), results.truncated.size());
  reader.take(block.data(), block.bytes());
  if (mode > kTerminated || mode == kMade || !std::isfinite(time)) throw Failure("the state of the unit is damaged");
  env_.load(reader.rest());  // before anything else is changed: it may refuse
  time_ = time;
  seed_ = seed;
  mode_ = static_cast<Mode>(mode);
  fresh_ = fresh != 0;
  actions_ = std::move(actions);
  results_ = std::move(results);
  block_ = std::move(block);
}

}  // namespace cli
