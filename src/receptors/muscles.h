// The receptors of muscles and joints: spindles, Golgi tendon organs, joint receptors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/bytes.h"

namespace mimo::receptors {

// How far the polar region of a spindle's fibre gives way within a tick.
//
// Its damping is that of Mileusnic et al.: a force beta (P - R) |v|^0.3 against its speed v, in parallel with springs
// of stiffness k. Where the springs alone would move it by p, it moves by m in a tick T, by an implicit step of
// Euler's:
//
//     m + c m^0.3 = p,  c = beta (P - R) / (k T^0.3)
//
// With m = c^(10/7) u this is u + u^0.3 = w, w = p c^(-10/7), for all fibres: m / p is a function of w alone.

class Creep {
 public:
  // T in seconds, k in force / L0. Makes tables, which takes a while.
  Creep(double tick, double stiffness);

  // What `moved` takes of beta: (k T^0.3 / beta)^(10/7). Costly.
  double ease(double damping) const;
  // m for p = `way` and P - R = `lever`, both in L0.
  double moved(double way, double lever, double ease) const;

 private:
  static constexpr std::size_t kSteps = 1024;
  using Table = std::array<double, kSteps + 1>;

  double force_;    // k T^0.3
  Table shares_{};  // m / p, at w / (1 + w) = 0 to 1
  Table powers_{};  // x^(10/7), at x = 0 to 1
};

// Muscle spindles: how long a muscle is and how fast it is stretched, as afferents Ia and II tell it, under the drive
// that its fusimotor neurons give it.
//
// The model of Mileusnic, Brown, Lan and Loeb 2006 (J Neurophysiol 96:1772) without the mass of its fibres: the polar
// region of each creeps on after a stretch. Fitted to cats; nothing is known of infants.

// Spikes a second of the gamma neurons.
struct FusimotorDrive {
  double dynamic_rate = 70, static_rate = 70;
};
constexpr double kMostFusimotorDrive = 500;  // more than any neuron fires

struct SpindleRates {
  double primary, secondary;  // Ia and II, Hz
};

// What a tick of so many seconds does to any spindle.
struct SpindleTick {
  explicit SpindleTick(double seconds);
  Creep creep;
  double kept_bag1, kept_bag2;  // of how much a fibre has yet to contract
};

class Spindle {
 public:
  // Length in units of the optimal length L0. It has been this long, and driven like this, for ever.
  void rest(double length, const FusimotorDrive& drive);
  // A tick later.
  void advance(double length, const FusimotorDrive& drive, const SpindleTick& tick);
  SpindleRates rates() const;

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  static constexpr std::size_t kFibres = 3;  // bag1, bag2, chain

  double length_ = 1;
  std::array<double, kFibres> drive_{};  // how much each fibre contracts: what its drive does in the end, 0 to 1
  std::array<double, kFibres> polar_{};  // lengths of their polar regions, L0
  std::array<double, kFibres> ease_{};   // follows from the drive; 0: not yet
};

// The lengths of a joint's muscle at the two ends of the joint's range: an estimate, about the range that the model was
// fitted in.
constexpr double kShortestMuscle = 0.80, kLongestMuscle = 1.10;  // L0

// Golgi tendon organs: how hard a muscle pulls, as afferents Ib tell it.
//
// Lin and Crago 2002 after Houk and Simon, with the constants of Elias 2014: a logarithm of the force, and dynamics
// H(s) = (1.7 s^2 + 2.58 s + 0.4) / (s^2 + 2.2 s + 0.4), of cats. The logarithm's constants for a share of the largest
// force are an estimate, as an infant's muscles have no trustworthy newtons.

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

// Joint receptors: they fire near the ends of a joint's range and hardly between. Rates and adaptation are an estimate.

// `nearness` to this end: 0 where the joint is more than the threshold inside, 1 at the limit; `closing` is how fast it
// grows, 1/s. Hz.
inline double joint_receptor(double nearness, double closing) {
  constexpr double kLargest = 100, kAdapts = 0.1, kMost = 200;  // Hz, s, Hz
  if (nearness <= 0) return 0;
  return std::min(kMost, kLargest * (std::min(1.0, nearness) + kAdapts * std::max(0.0, closing)));
}

}  // namespace mimo::receptors
