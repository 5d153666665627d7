#include "base/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace mimo {
namespace {

// The words of SplitMix64 and of xoshiro256++ as the reference programs of Blackman and Vigna give them
// (https://prng.di.unimi.it), for the seed 42.
TEST(Random, IsThePublishedGenerator) {
  Random random(42);
  std::vector<std::uint8_t> state(32);
  ByteWriter writer{Span<std::uint8_t>(state)};
  random.save(writer);
  ByteReader words{Span<const std::uint8_t>(state)};
  EXPECT_EQ(words.take<std::uint64_t>(), 0xbdd732262feb6e95u);
  EXPECT_EQ(words.take<std::uint64_t>(), 0x28efe333b266f103u);
  EXPECT_EQ(words.take<std::uint64_t>(), 0x47526757130f9f52u);
  EXPECT_EQ(words.take<std::uint64_t>(), 0x581ce1ff0e4ae394u);
  EXPECT_EQ(random.next(), 0xd0764d4f4476689fu);
  EXPECT_EQ(random.next(), 0x519e4174576f3791u);
  EXPECT_EQ(random.next(), 0xfbe07cfb0c24ed8cu);
}

TEST(Random, ContinuesFromItsState) {
  Random first(7);
  first.next();
  std::vector<std::uint8_t> state(32);
  ByteWriter writer{Span<std::uint8_t>(state)};
  first.save(writer);
  Random second(8);
  ByteReader reader{Span<const std::uint8_t>(state)};
  second.load(reader);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(first.next(), second.next());
}

TEST(Random, RefusesTheStateItCannotLeave) {
  Random random(7), same(7);
  const std::vector<std::uint8_t> zeros(32);
  ByteReader reader{Span<const std::uint8_t>(zeros)};
  EXPECT_THROW(random.load(reader), Error);
  EXPECT_EQ(random.next(), same.next());
}

TEST(Random, UniformStaysInItsRange) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(-2, 3);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 3);
  }
}

}  // namespace
}  // namespace mimo
