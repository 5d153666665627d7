#include "motion/spline.h"

#include <algorithm>

namespace cli {

Spline::Spline(std::vector<double> times, std::vector<double> values)
    : times_(std::move(times)), values_(std::move(values)), bends_(values_.size(), 0) {
  // Of each inner point: equal slopes from both sides, solved from the first to the last and back.
  const std::size_t n = values_.size();
  std::vector<double> share(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = times_[i] - times_[i - 1], right = times_[i + 1] - times_[i];
    const double turn = (values_[i + 1] - values_[i]) / right - (values_[i] - values_[i - 1]) / left;
    const double pivot = 2 * (left + right) - left * share[i - 1];
    share[i] = right / pivot;
    bends_[i] = (6 * turn - left * bends_[i - 1]) / pivot;
  }
  for (std::size_t i = n; i-- > 1;) {
    if (i + 1 < n) bends_[i] -= share[i] * bends_[i + 1];
  }
}

double Spline::at(double time) const {
  const std::size_t n = values_.size();
  if (n == 1) return values_[0];
  const auto found = std::upper_bound(times_.begin(), times_.end(), time);
  const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(found - times_.begin()), 1, n - 1);
  const double width = times_[i] - times_[i - 1];
  const double a = values_[i - 1], b = values_[i], p = bends_[i - 1], q = bends_[i];
  const double slope = (b - a) / width;
  if (time < times_[0]) return a + (time - times_[0]) * (slope - width * (2 * p + q) / 6);
  if (time > times_[n - 1]) return b + (time - times_[n - 1]) * (slope + width * (p + 2 * q) / 6);
  const double u = (time - times_[i - 1]) / width, v = 1 - u;
  return v * a + u * b + width * width / 6 * ((v * v * v - v) * p + (u * u * u - u) * q);
}

}  // namespace cli
