// A task that is written by the user, as C functions.
#pragma once

#include <vector>

#include "env/options.h"
#include "mimo/mimo.h"
#include "tasks/task.h"

namespace mimo::capi {

class CustomTask : public tasks::Task {
 public:
  // The world's host is where its handle is by the time that the task is asked to do something.
  CustomTask(const mimo_task& functions, const env::Identity& world, std::size_t agent);

  void reset(engine::Physics& physics, Random& random) override;
  void evaluate(const engine::Physics& physics) override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  mimo_task functions_;
  mimo_env* const* env_;
  std::size_t world_, agent_;
  std::vector<std::uint8_t> memory_;
};

}  // namespace mimo::capi
