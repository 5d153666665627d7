// The one random number generator: xoshiro256++ 1.0 (Blackman and Vigna, 2019), seeded by SplitMix64.
// It lives in the world, is set by reset and is part of the world's state.
#pragma once

#include <array>
#include <cstdint>

#include "base/bytes.h"

namespace mimo {

class Random {
 public:
  explicit Random(std::uint64_t seed = 0) { reseed(seed); }

  void reseed(std::uint64_t seed);
  std::uint64_t next();
  // Uniform in [0, 1): the upper 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  void save(ByteWriter& to) const { to.put(Span<const std::uint64_t>(state_)); }
  void load(ByteReader& from);

 private:
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace mimo
