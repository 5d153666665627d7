#include "receptors/creep.h"

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

constexpr double kExponent = 0.3;
constexpr double kTogether = 1 / (1 - kExponent);  // 10/7

// u / w where u + u^0.3 = w. With y = u^0.3 it is y^(10/3) + y = w, whose left side is convex: Newton's steps from
// above come down on the root.
double share_of(double w) {
  double y = std::min(w, std::pow(w, kExponent));
  for (int i = 0; i < 60; ++i) {
    const double rest = std::pow(y, 1 / kExponent - 1);
    const double next = y - (y * rest + y - w) / (rest / kExponent + 1);
    if (next == y) break;
    y = next;
  }
  return std::pow(y, 1 / kExponent) / w;
}

// Between the table's points; x from 0 to 1.
template <typename Table>
double between(const Table& table, double x) {
  const double at = x * static_cast<double>(table.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), table.size() - 2);
  const double part = at - static_cast<double>(i);
  return table[i] + part * (table[i + 1] - table[i]);
}

}  // namespace

Creep::Creep(double tick, double stiffness) : force_(stiffness * std::pow(tick, kExponent)) {
  for (std::size_t i = 1; i < kSteps; ++i) {
    shares_[i] = share_of(static_cast<double>(i) / static_cast<double>(kSteps - i));
  }
  shares_[kSteps] = 1;
  for (std::size_t i = 0; i <= kSteps; ++i) powers_[i] = std::pow(static_cast<double>(i) / kSteps, kTogether);
}

double Creep::ease(double damping) const { return std::pow(force_ / damping, kTogether); }

double Creep::moved(double way, double lever, double ease) const {
  if (lever <= 0 || way == 0) return way;
  const double eased = way * ease;  // w / (1 + w) with w = eased / lever^(10/7)
  return way * between(shares_, eased / (eased + between(powers_, std::min(lever, 1.0))));
}

}  // namespace mimo::receptors
