// The one random number generator: xoshiro256++ 1.0 (Blackman and Vigna, 2019), seeded by SplitMix64.
// It lives in the world, is set by reset and is part of the world's state.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "base/bytes.h"
#include "base/functions.h"

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

// Gaussian noise that depends on seeds alone: the same seeds give the same noise.

// What the noise of one field or path is made of in one step of an episode.
inline std::uint64_t noise_seed(std::uint64_t episode, std::uint64_t step, const std::string& name) {
  Hash hash;
  hash.add(episode);
  hash.add(step);
  hash.add(name);
  return hash.value();
}

// Independent numbers of the normal distribution (Box and Muller, 1958).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}

  double next() {
    if (left_) {
      left_ = false;
      return second_;
    }
    constexpr double kTurn = 6.28318530717958647692;
    const double radius = std::sqrt(-2 * fixed::log(1 - random_.uniform()));
    const double angle = kTurn * random_.uniform();
    second_ = radius * fixed::sin(angle);
    left_ = true;
    return radius * fixed::cos(angle);
  }

 private:
  Random random_;
  double second_ = 0;
  bool left_ = false;
};

}  // namespace mimo
