// Gaussian noise that follows from seeds alone: whoever asks again hears the same.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "base/hash.h"
#include "base/random.h"

namespace mimo {

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
    const double radius = std::sqrt(-2 * std::log(1 - random_.uniform()));
    const double angle = kTurn * random_.uniform();
    second_ = radius * std::sin(angle);
    left_ = true;
    return radius * std::cos(angle);
  }

 private:
  Random random_;
  double second_ = 0;
  bool left_ = false;
};

}  // namespace mimo
