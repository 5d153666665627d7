// A learned policy that acts in a world, as docs/guide/policies.md describes it.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "programs/policy_file.h"

namespace cli {

class Policy {
 public:
  // Throws a Failure for a file that cannot be read or is no policy.
  explicit Policy(const std::string& file) : name_(file), file_(read_policy(file)) {}

  // Finds its fields and joints in a world's layout. Throws a Failure that names what does not fit: another body, other
  // senses or motors, another length of a step.
  void attach(const mimo::Env& env);
  // What it does, given an observation of the world that it is attached to and the seconds since the episode began. An
  // earlier time than before is another episode's.
  const std::vector<float>& act(const mimo::Block& block, double time);

 private:
  struct Bounds {
    float low, high;
  };

  void attach_step(double step);
  void attach_actions(const std::vector<mimo_action>& actions);
  void attach_reflex(const mimo::Layout& layout);
  void think(const mimo::Block& block, double time);
  void pull(const mimo::Block& block);

  std::string name_;
  PolicyFile file_;
  double step_ = 0;
  std::int64_t hold_ = 1, last_ = -1;  // steps: of an output, and of the episode when it acted last; -1: never
  std::vector<mimo_field> places_;     // of the fields in the world's block
  mimo_field angles_{}, velocities_{};
  std::vector<std::size_t> joints_;  // of the reflex: elements of both
  std::vector<float> seen_;
  std::vector<std::vector<float>> rows_;  // what each layer gave
  std::vector<Bounds> bounds_;
  std::vector<float> commands_;
};

}  // namespace cli
