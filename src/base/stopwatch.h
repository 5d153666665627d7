// Adds the seconds of its own life to a sum; does nothing when switched off.
#pragma once

#include <chrono>

namespace mimo {

class Stopwatch {
 public:
  Stopwatch(bool on, double& sum) : sum_(on ? &sum : nullptr) {
    if (sum_ != nullptr) start_ = std::chrono::steady_clock::now();
  }
  ~Stopwatch() {
    if (sum_ != nullptr) *sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double* sum_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace mimo
