#include "statistics.h"

#include <algorithm>
#include <numeric>

namespace cli {

void FieldStatistics::add(const Block& block) {
  switch (field_.dtype) {
    case MIMO_U8: return add_values<std::uint8_t>(block);
    case MIMO_I32: return add_values<std::int32_t>(block);
    case MIMO_F32: return add_values<float>(block);
    case MIMO_F64: return add_values<double>(block);
    default: throw Failure("field " + field_.name + " has a type that this program does not know");
  }
}

template <typename T>
void FieldStatistics::add_values(const Block& block) {
  const T* begin = reinterpret_cast<const T*>(block.data() + field_.offset);
  const T* end = begin + field_.bytes / sizeof(T);
  if (begin == end) return;
  const auto [low, high] = std::minmax_element(begin, end);
  min_ = std::min(min_, static_cast<double>(*low));
  max_ = std::max(max_, static_cast<double>(*high));
  sum_ += std::accumulate(begin, end, 0.0);
  count_ += static_cast<std::size_t>(end - begin);
}

}  // namespace cli
