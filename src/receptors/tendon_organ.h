// Golgi tendon organs: how hard a muscle pulls, as afferents Ib tell it.
//
// Lin and Crago 2002 after Houk and Simon, with the constants of Elias 2014: a logarithm of the force, and dynamics
// H(s) = (1.7 s^2 + 2.58 s + 0.4) / (s^2 + 2.2 s + 0.4), of cats. The logarithm's constants for a share of the largest
// force are an estimate, as an infant's muscles have no trustworthy newtons.
#pragma once

#include "base/bytes.h"

namespace mimo::receptors {

class TendonOrgan {
 public:
  // `share` of the largest force, 0 or above.
  static double steady_rate(double share);

  // It has pulled like this for ever.
  void rest(double share);
  // As many seconds later.
  void advance(double share, double kept_slow, double kept_fast);
  double rate() const;  // Hz, 0 or above

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

  static constexpr double kSlow = 0.2, kFast = 2;  // rad/s, of its dynamics

 private:
  double drive_ = 0;            // Hz, before the dynamics
  double slow_ = 0, fast_ = 0;  // high-passed parts of it, Hz
};

}  // namespace mimo::receptors
