/**
 * @file mimo/hpp/task.hpp
 * Tasks of your own, which run inside reset and step. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_TASK
#define MIMO_HPP_TASK

#include <cstddef>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "env.hpp"

namespace mimo {
inline namespace v1_0 {

/// A field of the observation that a task fills: single precision, one for each agent.
struct TaskField {
  /// Without a shape it is one number.
  explicit TaskField(std::string name_, std::vector<std::size_t> shape_ = {}, std::string unit_ = "",
                     std::string frame_ = "")
      : name(std::move(name_)), shape(std::move(shape_)), unit(std::move(unit_)), frame(std::move(frame_)) {}

  std::string name;
  std::vector<std::size_t> shape;
  std::string unit, frame;
  /// Bounds of the values.
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// A task of your own, for Scene::set_task. It outlives the worlds that have it; those of a batch call it at the same
/// time, on several threads. What it throws fails the step or reset.
class Task {
 public:
  Task() = default;
  virtual ~Task() = default;
  Task(const Task &) = delete;
  Task &operator=(const Task &) = delete;

  /// Names of what the reward is the sum of; none: it is one number.
  virtual std::vector<std::string> terms() const { return {}; }
  virtual std::vector<TaskField> fields() const { return {}; }
  /// Bytes of moment.memory for each world and agent.
  virtual std::size_t memory_bytes() const { return 0; }

  /// Prepares an episode of moment.agent, in a world that is at its start.
  virtual void reset(Env &env, const mimo_task_moment &moment) { (void)env, (void)moment; }
  /// Judges a step of moment.agent. What it writes counts from the next step on.
  virtual void evaluate(Env &env, const mimo_task_moment &moment, mimo_task_verdict &verdict) = 0;
};

namespace detail {
/// A world whose owner is somebody else.
struct Borrowed {
  explicit Borrowed(mimo_env *world) : env(world) {}
  ~Borrowed() { env.release(); }
  Borrowed(const Borrowed &) = delete;
  Borrowed &operator=(const Borrowed &) = delete;
  Env env;
};
/// The status and the words of a call that failed inside. Exceptions end here, in the program, whatever they are: the
/// library may have been built with another C++ library, which could not read them, or another unwinder, which could not
/// catch them. Nothing is allocated here, for that might throw again.
template <typename Work>
mimo_status task_status(Work work) {
  try {
    work();
    return MIMO_OK;
  } catch (const Exception &error) {
    return mimo_fail(error.status(), error.what());
  } catch (const std::exception &error) {
    char message[1024];
    std::snprintf(message, sizeof message, "threw an exception: %s", error.what());
    return mimo_fail(MIMO_E_TASK, message);
  } catch (...) {
    return mimo_fail(MIMO_E_TASK, "threw what is no std::exception");
  }
}
inline mimo_status reset_task(void *user, mimo_env *world, const mimo_task_moment *moment) {
  Borrowed borrowed(world);
  return task_status([&] { static_cast<Task *>(user)->reset(borrowed.env, *moment); });
}
inline mimo_status evaluate_task(void *user, mimo_env *world, const mimo_task_moment *moment,
                                 mimo_task_verdict *verdict) {
  Borrowed borrowed(world);
  return task_status([&] { static_cast<Task *>(user)->evaluate(borrowed.env, *moment, *verdict); });
}
inline mimo_task_field task_field(const TaskField &field) {
  mimo_task_field raw = defaults(mimo_task_field_init);
  raw.name = field.name.c_str();
  raw.shape = field.shape.data();
  raw.ndim = static_cast<std::uint32_t>(field.shape.size());
  raw.unit = field.unit.c_str();
  raw.frame = field.frame.c_str();
  raw.low = field.low;
  raw.high = field.high;
  return raw;
}
}  // namespace detail

inline void Scene::set_task(Task &task) {
  const std::vector<std::string> terms = task.terms();
  const std::vector<TaskField> fields = task.fields();
  std::vector<const char *> names;
  for (const std::string &term : terms) names.push_back(term.c_str());
  std::vector<mimo_task_field> described;
  for (const TaskField &field : fields) described.push_back(detail::task_field(field));
  mimo_task raw = detail::defaults(mimo_task_init);
  raw.user = &task;
  raw.memory_bytes = task.memory_bytes();
  raw.reset = detail::reset_task;
  raw.evaluate = detail::evaluate_task;
  raw.terms = names.data();
  raw.term_count = names.size();
  raw.fields = described.data();
  raw.field_count = described.size();
  check(mimo_scene_set_task(get(), &raw));
}

}  // namespace v1_0
}  // namespace mimo

#endif
