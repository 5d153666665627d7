// What a sense gave over a run: smallest, largest and mean value of each field.
#pragma once

#include <limits>
#include <mimo/mimo.hpp>

namespace cli {

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

}  // namespace cli
