#include "hearing/spectrum.h"

#include <cmath>
#include <utility>

#include "base/angle.h"

namespace mimo::hearing {

Transform::Transform() {
  for (std::size_t i = 0; i < kWindow / 2; ++i) {
    const double angle = -2 * kPi * static_cast<double>(i) / static_cast<double>(kWindow);
    turns_.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
  }
  for (std::size_t i = 0; i < kWindow; ++i) {
    std::size_t mirrored = 0;
    for (std::size_t bit = 1, other = kWindow / 2; bit < kWindow; bit *= 2, other /= 2) {
      if ((i & bit) != 0) mirrored |= other;
    }
    order_.push_back(mirrored);
  }
}

void Transform::operator()(std::array<std::complex<float>, kWindow>& values) const {
  for (std::size_t i = 0; i < kWindow; ++i) {
    if (order_[i] > i) std::swap(values[i], values[order_[i]]);
  }
  for (std::size_t half = 1; half < kWindow; half *= 2) {
    const std::size_t stride = kWindow / (2 * half);
    for (std::size_t start = 0; start < kWindow; start += 2 * half) {
      for (std::size_t i = 0; i < half; ++i) {
        const std::complex<float> turn = turns_[i * stride], b = values[start + half + i];
        // By hand: std::complex would look for infinities.
        const std::complex<float> turned(turn.real() * b.real() - turn.imag() * b.imag(),
                                         turn.real() * b.imag() + turn.imag() * b.real());
        values[start + half + i] = values[start + i] - turned;
        values[start + i] += turned;
      }
    }
  }
}

}  // namespace mimo::hearing
