// A task of the user's own as it was described, with copies of all that the description refers to.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mimo/experimental.h"
#include "observation/field.h"

namespace mimo::capi {

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

}  // namespace mimo::capi
