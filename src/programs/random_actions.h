// Actions drawn uniformly between their bounds, the same everywhere for the same seed.
#pragma once

#include <mimo/mimo.hpp>
#include <random>
#include <vector>

namespace cli {

class RandomActions {
 public:
  RandomActions(const mimo::Env& env, std::uint64_t seed);
  std::vector<float> draw();

 private:
  struct Bounds {
    double low, high;
  };

  std::mt19937_64 generator_;
  std::vector<Bounds> bounds_;
};

}  // namespace cli
