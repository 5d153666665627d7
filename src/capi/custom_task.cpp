#include "capi/custom_task.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fail.h"
#include "base/format.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/handed.h"
#include "capi/objects.h"
#include "capi/own_code.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

constexpr std::size_t kMostBytes = 1048576;  // of memory, and of fields, so that states stay small
constexpr std::size_t kMostValues = kMostBytes / sizeof(float);

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

observation::Field field_of(const mimo_task_field& field, const std::string& argument) {
  observation::Field ours;
  ours.name = text(field.name);
  require(!ours.name.empty(), "{}: name is {}, expected one", argument, field.name == nullptr ? "NULL" : "\"\"");
  check_path(ours.name, argument);
  describe_field(field, kMostValues, argument, ours);
  ours.exempt = true;
  return ours;
}

std::vector<observation::Field> fields_of(const mimo_task& task) {
  std::vector<observation::Field> fields;
  for_each_of(task.fields, task.field_count, "task: fields",
              [&](const mimo_task_field& theirs, const std::string& argument) {
                observation::Field field = field_of(theirs, argument);
                for (const observation::Field& other : fields) {
                  require(other.name != field.name, "task: there are two fields \"{}\"", field.name);
                }
                fields.push_back(std::move(field));
              });
  return fields;
}

env::CustomTask maker(std::shared_ptr<const TaskPlan> plan) {
  return [plan = std::move(plan)](const env::Identity& world, std::size_t agent) {
    return std::make_unique<CustomTask>(plan, world, agent);
  };
}

std::vector<tasks::Term> terms_of(const TaskPlan& plan) {
  if (plan.terms.empty()) return {{"reward", 0.0}};
  std::vector<tasks::Term> all;
  for (const std::string& name : plan.terms) all.push_back({name.c_str(), 0.0});
  return all;
}

// All but what it does.
Json json_of(const TaskPlan& plan) {
  std::vector<Json> fields;
  for (const observation::Field& field : plan.fields) {
    fields.push_back({{"name", field.name},
                      {"unit", field.unit},
                      {"frame", field.frame},
                      {"shape", field.shape},
                      {"low", field.low},
                      {"high", field.high}});
  }
  return {{"memory_bytes", plan.memory_bytes}, {"terms", plan.terms}, {"fields", fields}};
}

template <typename T>
T* data_of(std::vector<T>& values) {
  return values.empty() ? nullptr : values.data();
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

CustomTask::CustomTask(std::shared_ptr<const TaskPlan> plan, const env::Identity& world, std::size_t agent)
    : Task(terms_of(*plan)),
      plan_(std::move(plan)),
      env_(static_cast<mimo_env* const*>(world.host)),
      world_(world.number),
      agent_(agent),
      memory_(plan_->memory_bytes),
      fields_(plan_->values()),
      new_fields_(fields_),
      new_terms_(plan_->terms.size()) {
  ends_ = true;
}

void CustomTask::tell(mimo_task_moment& moment) {
  moment.world = world_;
  moment.agent = agent_;
  moment.step = step_.number;
  moment.memory = data_of(memory_);
  moment.fields = data_of(new_fields_);
  moment.action = step_.actions.data();
  moment.action_count = step_.actions.size();
  moment.block = step_.block.data();
  moment.block_bytes = step_.block.size();
}

// What was observed last stays so where the function fails.
template <typename Call>
void CustomTask::ask(const char* function, Call&& call) {
  new_fields_ = fields_;
  call_out("the task", function, call);
  check_fields(function);
}

void CustomTask::reset(engine::Physics&, Random&) {
  std::fill(memory_.begin(), memory_.end(), std::uint8_t{0});
  std::fill(fields_.begin(), fields_.end(), 0.0f);
  if (plan_->reset == nullptr) return;
  Handed<mimo_task_moment> now;
  tell(*now);
  ask("reset", [&] { return plan_->reset(plan_->user, *env_, now.get()); });
  fields_ = new_fields_;
}

void CustomTask::evaluate(const engine::Physics&) {
  withdraw();
  std::fill(new_terms_.begin(), new_terms_.end(), 0.0);
  Handed<mimo_task_moment> now;
  tell(*now);
  Handed<mimo_task_verdict> said;
  const mimo_task_verdict& verdict = *said;
  said->terms = data_of(new_terms_);
  ask("evaluate", [&] { return plan_->evaluate(plan_->user, *env_, now.get(), said.get()); });
  if (const std::size_t byte = said.newer_at(); byte != 0) {
    fail(
        Status::kTask,
        "the task's function evaluate gave agent {} a verdict with a member at byte {}, which needs an interface newer "
        "than {}.{}: this one knows {} bytes",
        agent_, byte, MIMO_API_MAJOR, MIMO_API_MINOR, sizeof verdict);
  }
  check_terms(verdict);
  fields_ = new_fields_;
  if (new_terms_.empty()) terms_[0].value = verdict.reward;
  for (std::size_t i = 0; i < new_terms_.size(); ++i) terms_[i].value = new_terms_[i];
  success_ = verdict.outcome == MIMO_OUTCOME_SUCCESS;
  failure_ = verdict.outcome == MIMO_OUTCOME_FAILURE;
  ends_ = verdict.goes_on == 0;
  cut_off_ = verdict.truncated != 0;
}

void CustomTask::check_terms(const mimo_task_verdict& verdict) const {
  const auto check_known = [this](std::int64_t value, std::int64_t low, const char* name) {
    if (value >= low && value <= 1) return;
    fail(Status::kTask,
         "the task's function evaluate gave agent {} {} as {}, which needs an interface newer than {}.{}: this one "
         "knows {} to 1",
         agent_, name, value, MIMO_API_MAJOR, MIMO_API_MINOR, low);
  };
  check_known(verdict.outcome, MIMO_OUTCOME_FAILURE, "outcome");
  check_known(verdict.goes_on, 0, "goes_on");
  check_known(verdict.truncated, 0, "truncated");
  if (!new_terms_.empty() && verdict.reward != 0) {
    fail(Status::kTask,
         "the task's function evaluate gave agent {} the reward {} beside terms, expected 0: it is their sum", agent_,
         verdict.reward);
  }
  for (std::size_t i = 0; i < new_terms_.size(); ++i) {
    if (std::isfinite(new_terms_[i])) continue;
    fail(Status::kTask, "the task's function evaluate gave agent {} the term \"{}\" as {}, expected a finite number",
         agent_, terms_[i].name, new_terms_[i]);
  }
}

void CustomTask::check_fields(const char* function) const {
  const float* value = new_fields_.data();
  for (const observation::Field& field : plan_->fields) {
    const auto low = static_cast<float>(field.low), high = static_cast<float>(field.high);
    for (std::size_t i = 0; i < field.count(); ++i, ++value) {
      if (std::isfinite(*value) && *value >= low && *value <= high) continue;
      const std::string bounds = std::isfinite(low) || std::isfinite(high) ? format(" from {} to {}", low, high) : "";
      fail(Status::kTask, "the task's function {} gave agent {} {}[{}] as {}, expected a finite number{}", function,
           agent_, field.name, i, *value, bounds);
    }
  }
}

std::vector<observation::Signal> CustomTask::signals(const mjModel&) const {
  std::vector<observation::Signal> all;
  std::size_t start = 0;
  for (const observation::Field& field : plan_->fields) {
    const std::size_t count = field.count();
    all.push_back({field, [this, start, count](const mjModel&, const mjData&, float* out) {
                     std::copy_n(fields_.begin() + start, count, out);
                   }});
    start += count;
  }
  return all;
}

void CustomTask::save(ByteWriter& to) const {
  Task::save(to);
  to.put(ends_);
  to.put(cut_off_);
  to.put(Span<const float>(fields_));
  to.put(Span<const std::uint8_t>(memory_));
}

void CustomTask::load(ByteReader& from) {
  Task::load(from);
  ends_ = from.take_flag();
  cut_off_ = from.take_flag();
  from.take(Span<float>(fields_));
  for (const float value : fields_) require(std::isfinite(value), "the state holds {} for a task's field", value);
  from.take(Span<std::uint8_t>(memory_));
}

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_task_init(mimo_task* task, size_t size) noexcept {
  return guard([&] { write_struct(task, size, empty_task(), "task"); });
}

mimo_status mimo_task_field_init(mimo_task_field* field, size_t size) noexcept {
  return guard([&] { write_struct(field, size, empty_field(), "field"); });
}

mimo_status mimo_scene_set_task(mimo_scene* scene, const mimo_task* task) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    env::CustomTask own;
    Json described = nullptr;
    if (task != nullptr) {
      const std::shared_ptr<const TaskPlan> plan = task_plan(read_struct(task, "task"));
      own = maker(plan);
      described = json_of(*plan);
    }
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.task = std::move(own);
      note(edit, {{"call", "set_task"}, {"task", described}});
    });
  });
}

mimo_status mimo_env_random(mimo_env* env, double* values, size_t count) noexcept {
  return guard(env, [&] {
    const auto numbers = array(values, count, "values");
    Random& random = open(env).world().random();
    std::generate(numbers.begin(), numbers.end(), [&random] { return random.uniform(); });
  });
}

}  // extern "C"
