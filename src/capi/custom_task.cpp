#include "capi/custom_task.h"

#include <algorithm>

#include "base/floats.h"
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

// Quotes what the function said by mimo_fail, or what the call complained about whose status it returns.
void check(mimo_status status, const char* function) {
  if (status == MIMO_OK) return;
  const bool known = status < 0 && status >= MIMO_E_INTERNAL;
  const char* why = last_error().status == status ? last_error().text.data() : "";
  fail(known ? static_cast<Status>(status) : Status::kInternal, "the task's function {} returned {} ({}){}{}", function,
       status, mimo_status_name(status), *why == '\0' ? "" : ": ", why);
}

// A C++ program may let exceptions out of its functions.
template <typename Call>
void ask(const char* function, Call&& call) {
  const FreshError of_its_own;
  const PlainFloats plain;  // what it changes of how this thread calculates ends with it
  try {
    check(call(), function);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    fail(Status::kInternal, "the task's function {} threw an exception: {}", function, error.what());
  } catch (...) {
    fail(Status::kInternal, "the task's function {} threw an unknown exception", function);
  }
}

mimo_task empty_task() {
  mimo_task task{};
  task.struct_size = sizeof task;
  return task;
}

env::CustomTask custom_task(const mimo_task& functions) {
  check_reserved(functions.reserved, "task: reserved");
  require(functions.evaluate != nullptr, "task: evaluate is NULL");
  require(functions.memory_bytes <= MIMO_TASK_MEMORY_LIMIT, "task: memory_bytes is {}, expected up to {}",
          functions.memory_bytes, MIMO_TASK_MEMORY_LIMIT);
  return [functions](const env::Identity& world, std::size_t agent) {
    return std::make_unique<CustomTask>(functions, world, agent);
  };
}

}  // namespace

CustomTask::CustomTask(const mimo_task& functions, const env::Identity& world, std::size_t agent)
    : Task({{"reward", 0.0}}),
      functions_(functions),
      env_(static_cast<mimo_env* const*>(world.host)),
      world_(world.number),
      agent_(agent),
      memory_(functions.memory_bytes) {
  ends_ = true;
}

void CustomTask::reset(engine::Physics&, Random&) {
  std::fill(memory_.begin(), memory_.end(), std::uint8_t{0});
  if (functions_.reset == nullptr) return;
  ask("reset", [this] { return functions_.reset(functions_.user, *env_, world_, agent_, memory_.data()); });
}

void CustomTask::evaluate(const engine::Physics&) {
  double reward = 0;
  int32_t outcome = MIMO_OUTCOME_NONE;
  ask("evaluate",
      [&] { return functions_.evaluate(functions_.user, *env_, world_, agent_, memory_.data(), &reward, &outcome); });
  terms_[0].value = reward;
  success_ = outcome > 0;
  failure_ = outcome < 0;
}

void CustomTask::save(ByteWriter& to) const {
  Task::save(to);
  to.put(Span<const std::uint8_t>(memory_));
}

void CustomTask::load(ByteReader& from) {
  Task::load(from);
  from.take(Span<std::uint8_t>(memory_));
}

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_task_init(mimo_task* task, size_t size) noexcept {
  return guard([&] { write_struct(task, size, empty_task(), "task"); });
}

mimo_status mimo_scene_set_task(mimo_scene* scene, const mimo_task* task) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    env::CustomTask own;
    if (task != nullptr) own = custom_task(read_struct(task, empty_task(), "task"));
    blueprint.edit([&](blueprint::Draft& draft) { draft.task = std::move(own); });
  });
}

mimo_status mimo_env_random(mimo_env* env, double* values, size_t count) noexcept {
  return guard(env, [&] {
    const auto numbers = array(values, count, "values");
    Random& random = open(env).world.random();
    std::generate(numbers.begin(), numbers.end(), [&random] { return random.uniform(); });
  });
}

}  // extern "C"
