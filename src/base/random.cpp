#include "base/random.h"

#include <algorithm>

namespace mimo {
namespace {

std::uint64_t rotate_left(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

// SplitMix64 spreads a seed of few bits over the whole state.
std::uint64_t split_mix(std::uint64_t& x) {
  x += 0x9e3779b97f4a7c15u;
  std::uint64_t z = x;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

void Random::reseed(std::uint64_t seed) {
  for (std::uint64_t& word : state_) word = split_mix(seed);
}

void Random::load(ByteReader& from) {
  std::array<std::uint64_t, 4> state{};
  from.take(Span<std::uint64_t>(state));
  const bool zero = std::all_of(state.begin(), state.end(), [](std::uint64_t word) { return word == 0; });
  require(!zero, "the random generator in the state is all zeros, which no generator reaches");  // it would stay there
  state_ = state;
}

std::uint64_t Random::next() {
  auto& s = state_;
  const std::uint64_t result = rotate_left(s[0] + s[3], 23) + s[0];
  const std::uint64_t t = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = rotate_left(s[3], 45);
  return result;
}

}  // namespace mimo
