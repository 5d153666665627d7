#include "tasks/task.h"

#include <algorithm>
#include <vector>

#include "base/fail.h"

namespace mimo::tasks {
namespace {

const Parameter& find(const std::string& name) {
  for (const Parameter* candidate : parameters()) {
    if (name == candidate->name) return *candidate;
  }
  fail_unknown_parameter(name);
}

// No task: the reward is 0 and episodes do not end.
class None : public Task {
 public:
  None() : Task({}) {}
};

constexpr Definition kNone = {
    "none", {}, [](const mjModel&, const body::Body&, const Settings&) -> std::unique_ptr<Task> {
      return std::make_unique<None>();
    }};
constexpr const Definition* kDefinitions[] = {&kNone,     &kReach,     &kStandup,    &kSelfbody, &kCatch,
                                              &kRollover, &kSelftouch, &kHandregard, &kBehaviour};

}  // namespace

std::vector<const Parameter*> parameters() {
  std::vector<const Parameter*> all;
  for (const Definition* task : definitions()) {
    for (const Parameter& parameter : task->parameters) all.push_back(&parameter);
  }
  return all;
}

void fail_unknown_parameter(const std::string& name, std::vector<std::string> further) {
  for (const Parameter* known : parameters()) further.emplace_back(known->name);
  fail(Status::kNotFound, "no parameter named \"{}\"; {}", name, choice_of(name, std::move(further)));
}

bool is_parameter(const std::string& name) {
  const std::vector<const Parameter*> all = parameters();
  return std::any_of(all.begin(), all.end(), [&](const Parameter* known) { return name == known->name; });
}

void Settings::set(const std::string& name, double value) {
  const Parameter& known = find(name);
  require(value >= known.low && value <= known.high, "{} is {}, expected {} to {}", name, value, known.low, known.high);
  values_[name] = value;
}

double Settings::operator[](const std::string& name) const {
  const auto found = values_.find(name);
  return found != values_.end() ? found->second : find(name).standard;
}

double Task::reward() const {
  double sum = 0;
  for (const Term& term : terms_) sum += term.value;
  return sum;
}

Outcome Task::outcome() const {
  if (success_) return Outcome::kSuccess;
  return failure_ ? Outcome::kFailure : Outcome::kNone;
}

void Task::clear() {
  withdraw();
  step_ = {};
}

void Task::withdraw() {
  for (Term& term : terms_) term.value = 0;
  success_ = failure_ = cut_off_ = false;
}

void Task::save(ByteWriter& to) const {
  for (const Term& term : terms_) to.put(term.value);
  to.put(success_);
  to.put(failure_);
}

void Task::load(ByteReader& from) {
  for (Term& term : terms_) term.value = from.take_finite("a reward");
  success_ = from.take_flag();
  failure_ = from.take_flag();
}

Span<const Definition* const> definitions() { return {kDefinitions, std::size(kDefinitions)}; }

const Definition& definition(const std::string& name) {
  if (name.empty()) return kNone;
  std::vector<std::string> names;
  for (const Definition* candidate : definitions()) {
    if (name == candidate->name) return *candidate;
    names.emplace_back(candidate->name);
  }
  fail(Status::kNotFound, "no task named \"{}\"; {}", name, choice_of(name, std::move(names)));
}

}  // namespace mimo::tasks
