// Actions drawn uniformly between their bounds, the same everywhere for the same seed.
#pragma once

#include <random>
#include <vector>

#include "api.h"

namespace cli {

class RandomActions {
 public:
  RandomActions(const Env& env, std::uint64_t seed);
  std::vector<float> draw();

 private:
  std::mt19937_64 generator_;
  std::vector<float> low_, high_;
};

}  // namespace cli
