#include <algorithm>

#include "tasks/task.h"

namespace mimo::tasks {
namespace {

class None : public Task {
 public:
  void reset(engine::Physics&, Random&) override {}
  void evaluate(const engine::Physics&, Span<double> reward, Span<std::uint8_t> terminated) override {
    std::fill(reward.begin(), reward.end(), 0.0);
    std::fill(terminated.begin(), terminated.end(), std::uint8_t{0});
  }
};

}  // namespace

std::unique_ptr<Task> make_none() { return std::make_unique<None>(); }

}  // namespace mimo::tasks
