#include "base/hash.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace mimo {
namespace {

std::uint64_t hash_of(const std::vector<std::uint8_t>& bytes) {
  Hash hash;
  hash.add(Span<const std::uint8_t>(bytes));
  return hash.value();
}

TEST(Hash, NoticesEveryFlippedBitAndEveryCut) {
  std::vector<std::uint8_t> bytes(43);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(37 * i);
  std::set<std::uint64_t> seen = {hash_of(bytes)};
  std::size_t variants = 1;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit, ++variants) {
    auto changed = bytes;
    changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ (1u << (bit % 8)));
    seen.insert(hash_of(changed));
  }
  for (std::size_t length = 0; length < bytes.size(); ++length, ++variants) {
    seen.insert(hash_of({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}));
  }
  EXPECT_EQ(seen.size(), variants);
}

TEST(Hash, CountsZeroBytes) { EXPECT_NE(hash_of({0, 0}), hash_of({0, 0, 0})); }

}  // namespace
}  // namespace mimo
