#include "tasks/parameters.h"

#include <vector>

#include "base/choice.h"
#include "base/fail.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

const Parameter& find(const std::string& name) {
  std::vector<std::string> names;
  for (const Parameter* candidate : parameters()) {
    if (name == candidate->name) return *candidate;
    names.emplace_back(candidate->name);
  }
  fail(Status::kNotFound, "no parameter named \"{}\"; {}", name, choice_of(name, std::move(names)));
}

}  // namespace

std::vector<const Parameter*> parameters() {
  std::vector<const Parameter*> all;
  for (const Definition* task : definitions()) {
    for (const Parameter& parameter : task->parameters) all.push_back(&parameter);
  }
  return all;
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

}  // namespace mimo::tasks
