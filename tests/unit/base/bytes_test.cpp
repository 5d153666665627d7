#include "base/bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace mimo {
namespace {

TEST(Bytes, AreReadBackAsWritten) {
  const std::array<double, 3> numbers = {1.5, -0.0, 1e300};
  ByteWriter counter;
  const auto write = [&](ByteWriter& to) {
    to.put(std::uint8_t{7});
    to.put(Span<const double>(numbers));
    to.put(std::int64_t{-5});
  };
  write(counter);
  EXPECT_EQ(counter.size(), 1 + 24 + 8u);

  std::vector<std::uint8_t> bytes(counter.size());
  ByteWriter writer{Span<std::uint8_t>(bytes)};
  write(writer);
  EXPECT_EQ(writer.size(), counter.size());

  ByteReader reader{Span<const std::uint8_t>(bytes)};
  std::array<double, 3> back{};
  EXPECT_EQ(reader.take<std::uint8_t>(), 7);
  reader.take(Span<double>(back));
  EXPECT_EQ(back, numbers);
  EXPECT_EQ(reader.left(), 8u);
  EXPECT_EQ(reader.take<std::int64_t>(), -5);
  EXPECT_EQ(reader.left(), 0u);
}

TEST(Bytes, NeverReachBeyondTheirEnd) {
  std::array<std::uint8_t, 7> bytes{};
  ByteReader reader{Span<const std::uint8_t>(bytes)};
  EXPECT_THROW(reader.take<double>(), Error);
  EXPECT_EQ(reader.left(), 7u);
  EXPECT_EQ(reader.skip(7).size(), 7u);
  EXPECT_THROW(reader.skip(1), Error);

  ByteWriter writer{Span<std::uint8_t>(bytes)};
  EXPECT_THROW(writer.put(1.0), Error);
}

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
