// The generator's numbers, so that seeds mean the same everywhere and for ever.
#include "base/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace mimo::test {
namespace {

// From an implementation of the published algorithms in another language: SplitMix64 fills the state, then
// xoshiro256++ 1.0 (prng.di.unimi.it).
TEST(BaseRandom, KnownNumbers) {
  Random zero(0);
  for (const std::uint64_t expected :
       {0x53175d61490b23dfu, 0x61da6f3dc380d507u, 0x5c0fdf91ec9a7bfcu, 0x02eebf8c3bbe5e1au})
    EXPECT_EQ(zero.next(), expected);
  Random other(0xdeadbeef12345678u);
  for (const std::uint64_t expected :
       {0xe184f656e3a75323u, 0xe7e37c704deb7cd6u, 0x0317a663fe286039u, 0xfd42d8445a91652bu})
    EXPECT_EQ(other.next(), expected);
}

TEST(BaseRandom, ReseedStartsAgain) {
  Random random(7);
  const std::uint64_t first = random.next();
  random.next();
  random.reseed(7);
  EXPECT_EQ(random.next(), first);
  random.reseed(8);
  EXPECT_NE(random.next(), first);
}

// The upper 53 bits of the same stream.
TEST(BaseRandom, UniformIsInItsRange) {
  Random random(1), bits(1);
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double value = random.uniform();
    EXPECT_EQ(value, static_cast<double>(bits.next() >> 11) / 9007199254740992.0);
    EXPECT_GE(value, 0);
    EXPECT_LT(value, 1);
    sum += value;
  }
  EXPECT_NEAR(sum / 10000, 0.5, 0.015);  // five standard deviations of the mean, 0.0029
  EXPECT_EQ(Random(2).uniform(-3, 5), -3 + 8 * Random(2).uniform());
}

TEST(BaseRandom, ContinuesFromItsState) {
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

TEST(BaseRandom, RefusesTheStateItCannotLeave) {
  Random random(7), same(7);
  const std::vector<std::uint8_t> zeros(32);
  ByteReader reader{Span<const std::uint8_t>(zeros)};
  EXPECT_THROW(random.load(reader), Error);
  EXPECT_EQ(random.next(), same.next());
}

}  // namespace
}  // namespace mimo::test
