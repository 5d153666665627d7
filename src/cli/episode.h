// What became of an episode of the first infant: its reward, its outcome, what its task measured.
#pragma once

#include <mimo/mimo.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "programs/world.h"

namespace cli {

class Episode {
 public:
  // Counts one step. `simulated` is the time since the start, s.
  void add(const mimo::Results& results, double simulated);
  // Whether the task has ended it.
  bool over() const { return over_; }
  // As --json prints it. The scene's behaviour is that of its document.
  nlohmann::ordered_json describe(const mimo::Env& env, const WorldOptions& options) const;

 private:
  std::size_t steps_ = 0;
  double seconds_ = 0, reward_ = 0;
  std::optional<double> reached_;  // seconds until the first success
  std::int32_t outcome_ = MIMO_OUTCOME_NONE;
  bool over_ = false;
};

}  // namespace cli
