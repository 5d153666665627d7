// Bits of the header that say what of something is wanted.
#pragma once

#include <cstdint>

namespace mimo {

// Whether one of some bits is there.
constexpr bool has_bit(std::uint32_t bits, std::uint32_t some) { return (bits & some) != 0; }

// The bits of all rows of a table.
template <typename Table>
constexpr std::uint32_t bits_of(const Table& table) {
  std::uint32_t all = 0;
  for (const auto& row : table) all |= row.bit;
  return all;
}

}  // namespace mimo
