#include "capi/task_plan.h"

#include <algorithm>
#include <limits>

#include "base/fail.h"
#include "base/format.h"
#include "capi/check.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

constexpr std::size_t kMostParts = 1000;     // terms, and fields: beyond this it is a count that was never set
constexpr std::size_t kMostBytes = 1048576;  // of memory, and of fields, so that states stay small
constexpr std::size_t kMostValues = kMostBytes / sizeof(float);

template <typename T>
Span<T> parts(T* data, std::size_t count, const char* argument) {
  require(count <= kMostParts, "{} has a length of {}, expected up to {}", argument, count, kMostParts);
  return array(data, count, argument);
}

std::vector<std::string> terms_of(const mimo_task& task) {
  std::vector<std::string> terms;
  for (const char* name : parts(task.terms, task.term_count, "task: terms")) {
    const std::string term = text(name);
    require(!term.empty(), "task: terms[{}] is {}, expected a name", terms.size(), name == nullptr ? "NULL" : "\"\"");
    require(std::find(terms.begin(), terms.end(), term) == terms.end(), "task: there are two terms \"{}\"", term);
    terms.push_back(term);
  }
  return terms;
}

std::vector<std::size_t> shape_of(const mimo_task_field& field, const std::string& argument) {
  require(field.ndim <= 4, "{}: ndim is {}, expected up to 4", argument, field.ndim);
  if (field.ndim == 0) return {1};
  const Span<const std::size_t> sizes = array(field.shape, field.ndim, (argument + ": shape").c_str());
  std::size_t count = 1;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    require(sizes[i] >= 1 && sizes[i] <= kMostValues, "{}: shape[{}] is {}, expected 1 to {}", argument, i, sizes[i],
            kMostValues);
    count *= sizes[i];
    require(count <= kMostValues, "{}: it has more than {} numbers", argument, kMostValues);
  }
  return {sizes.begin(), sizes.end()};
}

observation::Field field_of(const mimo_task_field& field, const std::string& argument) {
  observation::Field ours;
  ours.name = text(field.name);
  require(!ours.name.empty(), "{}: name is {}, expected one", argument, field.name == nullptr ? "NULL" : "\"\"");
  require(ours.name.front() != '/' && ours.name.back() != '/', "{}: name is \"{}\", expected no / at its ends",
          argument, ours.name);
  ours.shape = shape_of(field, argument);
  ours.unit = text(field.unit);
  ours.frame = text(field.frame);
  require(field.low < field.high, "{}: low is {} and high is {}, expected low < high", argument, field.low, field.high);
  ours.low = field.low;
  ours.high = field.high;
  ours.exempt = true;
  return ours;
}

// A newer caller's fields are longer than ours: each says where the next one begins.
std::vector<observation::Field> fields_of(const mimo_task& task) {
  std::vector<observation::Field> fields;
  const auto* next =
      reinterpret_cast<const unsigned char*>(parts(task.fields, task.field_count, "task: fields").data());
  for (std::size_t i = 0; i < task.field_count; ++i) {
    const auto* theirs = reinterpret_cast<const mimo_task_field*>(next);
    const std::string argument = format("task: fields[{}]", i);
    const mimo_task_field ours = read_struct(theirs, argument.c_str());
    require(theirs->struct_size % alignof(mimo_task_field) == 0, "{}: struct_size is {}, expected a multiple of {}",
            argument, theirs->struct_size, alignof(mimo_task_field));
    next += theirs->struct_size;
    observation::Field field = field_of(ours, argument);
    for (const observation::Field& other : fields) {
      require(other.name != field.name, "task: there are two fields \"{}\"", field.name);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace

std::size_t TaskPlan::values() const {
  std::size_t count = 0;
  for (const observation::Field& field : fields) count += field.count();
  return count;
}

std::shared_ptr<const TaskPlan> task_plan(const mimo_task& task) {
  check_reserved(task.reserved, "task: reserved");
  require(task.evaluate != nullptr, "task: evaluate is NULL");
  require(task.memory_bytes <= kMostBytes, "task: memory_bytes is {}, expected up to {}", task.memory_bytes,
          kMostBytes);
  TaskPlan plan{task.user, task.memory_bytes, task.reset, task.evaluate, terms_of(task), fields_of(task)};
  require(plan.values() <= kMostValues, "task: its fields have {} numbers together, expected up to {}", plan.values(),
          kMostValues);
  return std::make_shared<const TaskPlan>(std::move(plan));
}

mimo_task empty_task() {
  mimo_task task{};
  task.struct_size = sizeof task;
  return task;
}

mimo_task_field empty_field() {
  mimo_task_field field{};
  field.struct_size = sizeof field;
  field.low = -std::numeric_limits<double>::infinity();
  field.high = std::numeric_limits<double>::infinity();
  return field;
}

}  // namespace mimo::capi
