#include "receptors/tendon_organ.h"

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

constexpr double kGain = 40;  // Hz
constexpr double kScale = 20;

// H(s) = 1 + a s/(s + 0.2) + b s/(s + 2): from (1.7 s^2 + 2.58 s + 0.4) with poles at s^2 + 2.2 s + 0.4 = (s + 0.2)
// (s + 2): a + b = 0.7 and 2 a + 0.2 b = 0.38.
constexpr double kSlowGain = (0.38 - 0.2 * 0.7) / 1.8, kFastGain = 0.7 - kSlowGain;

}  // namespace

double TendonOrgan::steady_rate(double share) { return kGain * std::log1p(kScale * std::max(0.0, share)); }

void TendonOrgan::rest(double share) {
  drive_ = steady_rate(share);
  slow_ = fast_ = 0;
}

void TendonOrgan::advance(double share, double kept_slow, double kept_fast) {
  const double now = steady_rate(share), change = now - drive_;
  slow_ = kept_slow * slow_ + change;
  fast_ = kept_fast * fast_ + change;
  drive_ = now;
}

double TendonOrgan::rate() const { return std::max(0.0, drive_ + kSlowGain * slow_ + kFastGain * fast_); }

void TendonOrgan::save(ByteWriter& to) const {
  for (const double number : {drive_, slow_, fast_}) to.put(number);
}

void TendonOrgan::load(ByteReader& from) {
  for (double* number : {&drive_, &slow_, &fast_}) *number = from.take_finite("a tendon organ");
}

}  // namespace mimo::receptors
