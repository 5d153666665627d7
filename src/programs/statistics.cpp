#include "programs/statistics.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "programs/failure.h"

namespace cli {

void FieldStatistics::add(const mimo::Block& block) {
  switch (field_.dtype) {
    case MIMO_U8: return add_values<std::uint8_t>(block);
    case MIMO_I32: return add_values<std::int32_t>(block);
    case MIMO_F32: return add_values<float>(block);
    case MIMO_F64: return add_values<double>(block);
    default: throw Failure("field " + std::string(field_.name) + " has a type that this program does not know");
  }
}

template <typename T>
void FieldStatistics::add_values(const mimo::Block& block) {
  const auto values = block.view<T>(field_);
  if (values.size() == 0) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  min_ = std::min(min_, static_cast<double>(*low));
  max_ = std::max(max_, static_cast<double>(*high));
  sum_ += std::accumulate(values.begin(), values.end(), 0.0);
  count_ += values.size();
}

}  // namespace cli
