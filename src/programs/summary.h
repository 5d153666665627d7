// What several commands report of a world: its parts, its senses' values, its time.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <mimo/mimo.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cli {

// Where the time of steps went, and a stopwatch.

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Milliseconds a step: physics, touch, vision, proprioception, vestibular, hearing where somebody does, and `other`,
// which makes the sum equal to the given total.
std::vector<std::pair<std::string, double>> split_ms(const mimo_timing& timing, double total_ms);

// What a sense gave over a run: smallest, largest and mean value of each field.

class FieldStatistics {
 public:
  // Of a field of a world that outlives it.
  explicit FieldStatistics(const mimo_field& field) : field_(field) {}
  void add(const mimo::Block& block);

  const mimo_field& field() const { return field_; }
  double min() const { return min_; }
  double max() const { return max_; }
  double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

 private:
  template <typename T>
  void add_values(const mimo::Block& block);

  mimo_field field_;
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
  double sum_ = 0;
  std::size_t count_ = 0;
};

// What several commands tell of a world.

std::vector<std::int32_t> infants(const mimo::Env& env);  // their root bodies, agents or not
std::string prefix(const mimo_agent_info& agent);         // of its fields
std::size_t touch_sensors(const mimo::Env& env);          // of all agents

// How the model calls a joint; "free:<body>" for one that moves a whole body and has no name.
std::string joint_label(const mimo::Env& env, std::int32_t joint);

const char* dtype_name(const mimo_field& field);
std::vector<std::size_t> shape(const mimo_field& field);
std::string shape_text(const mimo_field& field);  // "256x256x3"
std::string or_dash(const std::string& text);     // "-" where there is none

}  // namespace cli
