#include "tasks/task.h"

#include "base/choice.h"
#include "base/fail.h"
#include "tasks/catch.h"
#include "tasks/handregard.h"
#include "tasks/reach.h"
#include "tasks/rollover.h"
#include "tasks/selfbody.h"
#include "tasks/selftouch.h"
#include "tasks/standup.h"

namespace mimo::tasks {
namespace {

// No task: the reward is 0 and episodes do not end.
class None : public Task {
 public:
  None() : Task({}) {}
};

constexpr Definition kNone = {
    "none", {}, [](const mjModel&, const body::Body&, const Settings&) -> std::unique_ptr<Task> {
      return std::make_unique<None>();
    }};
constexpr const Definition* kDefinitions[] = {&kNone,  &kReach,    &kStandup,   &kSelfbody,
                                              &kCatch, &kRollover, &kSelftouch, &kHandregard};

}  // namespace

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
