// Sound of two ears as a WAV file of 16 bits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mimo/mimo.hpp"

namespace cli {

class Wave {
 public:
  // Of the agent with this prefix of its fields; throws a Failure where it hears nothing.
  Wave(const mimo::Layout& layout, const std::string& prefix);
  // What a step gave.
  void add(const mimo::Block& block);
  // Throws a Failure where that cannot be written. What is louder than `full_scale` Pa is cut.
  void write(const std::string& path, double full_scale) const;
  // The loudest sample, Pa.
  float peak() const { return peak_; }

 private:
  mimo_field left_, right_;
  std::vector<float> samples_;  // left and right in turns
  float peak_ = 0;
};

}  // namespace cli
