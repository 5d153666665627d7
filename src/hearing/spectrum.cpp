#include "hearing/spectrum.h"

#include <cmath>

#include "base/angle.h"

namespace mimo::hearing {
namespace {

constexpr std::size_t kQuarter = kBins / 4;

void set_turn(Complexes& turns, std::size_t at, double part) {
  turns.real[at] = static_cast<float>(std::cos(-2 * kPi * part));
  turns.imag[at] = static_cast<float>(std::sin(-2 * kPi * part));
}

// A number times a turn, by hand: std::complex would look for infinities.
void put(Complexes& to, std::size_t at, float real, float imag, float cosine, float sine) {
  to.real[at] = cosine * real - sine * imag;
  to.imag[at] = cosine * imag + sine * real;
}

}  // namespace

Transform::Transform() {
  for (std::size_t i = 0; i < kBins; ++i) {
    for (std::size_t k = 0; k < turns_.size(); ++k) set_turn(turns_[k], i, static_cast<double>(k * i) / kBins);
    set_turn(half_turns_, i, static_cast<double>(i) / kWindow);
  }
}

// Numbers that are turned alike lie in groups, side by side.
template <std::size_t kGroup>
void Transform::quarter(const Complexes& from, Complexes& to) const {
  for (std::size_t first = 0; first < kQuarter; first += kGroup) {
    for (std::size_t i = first; i < first + kGroup; ++i) {
      const float *x = &from.real[i], *y = &from.imag[i];
      const float even_x = x[0] + x[2 * kQuarter], odd_x = x[0] - x[2 * kQuarter];
      const float even_y = y[0] + y[2 * kQuarter], odd_y = y[0] - y[2 * kQuarter];
      const float both_x = x[kQuarter] + x[3 * kQuarter], off_x = x[kQuarter] - x[3 * kQuarter];
      const float both_y = y[kQuarter] + y[3 * kQuarter], off_y = y[kQuarter] - y[3 * kQuarter];
      const std::size_t at = 3 * first + i;
      to.real[at] = even_x + both_x;
      to.imag[at] = even_y + both_y;
      put(to, at + kGroup, odd_x + off_y, odd_y - off_x, turns_[1].real[first], turns_[1].imag[first]);
      put(to, at + 2 * kGroup, even_x - both_x, even_y - both_y, turns_[2].real[first], turns_[2].imag[first]);
      put(to, at + 3 * kGroup, odd_x - off_y, odd_y + off_x, turns_[3].real[first], turns_[3].imag[first]);
    }
  }
}

Complexes Transform::operator()(const std::array<float, kWindow>& samples) const {
  Complexes one, other;
  for (std::size_t i = 0; i < kBins; ++i) {
    one.real[i] = samples[2 * i];
    one.imag[i] = samples[2 * i + 1];
  }
  quarter<1>(one, other);
  quarter<4>(other, one);
  quarter<16>(one, other);
  quarter<64>(other, one);
  // Even samples were real parts, odd ones imaginary: their spectra come apart by symmetry.
  other.real[0] = one.real[0] + one.imag[0];
  other.imag[0] = 0;
  for (std::size_t i = 1; i < kBins; ++i) {
    const std::size_t mirrored = kBins - i;
    const float even_x = one.real[i] + one.real[mirrored], even_y = one.imag[i] - one.imag[mirrored];
    const float odd_x = one.imag[i] + one.imag[mirrored], odd_y = one.real[mirrored] - one.real[i];
    put(other, i, odd_x, odd_y, half_turns_.real[i], half_turns_.imag[i]);
    other.real[i] = 0.5F * (even_x + other.real[i]);
    other.imag[i] = 0.5F * (even_y + other.imag[i]);
  }
  return other;
}

}  // namespace mimo::hearing
