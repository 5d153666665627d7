// A task that the user has written as C functions: its description, copied, and the task that calls them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "env/options.h"
#include "mimo/experimental.h"
#include "observation/field.h"
#include "tasks/task.h"

namespace mimo::capi {

// A task of the user's own as it was described, with copies of all that the description refers to.

struct TaskPlan {
  void* user = nullptr;
  std::size_t memory_bytes = 0;
  mimo_task_reset_fn reset = nullptr;
  mimo_task_evaluate_fn evaluate = nullptr;
  std::vector<std::string> terms;  // empty: the reward is one number
  std::vector<observation::Field> fields;

  // How many numbers the fields have together.
  std::size_t values() const;
};

std::shared_ptr<const TaskPlan> task_plan(const mimo_task& task);

mimo_task empty_task();
mimo_task_field empty_field();

// A task that is written by the user, as C functions.

class CustomTask : public tasks::Task {
 public:
  // The world's host is where its handle is by the time that the task is asked to do something.
  CustomTask(std::shared_ptr<const TaskPlan> plan, const env::Identity& world, std::size_t agent);

  void reset(engine::Physics& physics, Random& random) override;
  bool judges_senses() const override { return true; }
  void evaluate(const engine::Physics& physics) override;
  std::vector<observation::Signal> signals(const mjModel& model) const override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  void tell(mimo_task_moment& moment);
  template <typename Call>
  void ask(const char* function, Call&& call);
  void check_terms(const mimo_task_verdict& verdict) const;
  void check_fields(const char* function) const;

  std::shared_ptr<const TaskPlan> plan_;
  mimo_env* const* env_;
  std::size_t world_, agent_;
  std::vector<std::uint8_t> memory_;
  std::vector<float> fields_;
  // What the functions write; it counts when it is found to be good.
  std::vector<float> new_fields_;
  std::vector<double> new_terms_;
};

}  // namespace mimo::capi
