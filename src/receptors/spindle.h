// Muscle spindles: how long a muscle is and how fast it is stretched, as afferents Ia and II tell it, under the drive
// that its fusimotor neurons give it.
//
// The model of Mileusnic, Brown, Lan and Loeb 2006 (J Neurophysiol 96:1772) without the mass of its fibres: the polar
// region of each creeps on after a stretch. Fitted to cats; nothing is known of infants.
#pragma once

#include <array>
#include <cstddef>

#include "base/bytes.h"
#include "receptors/creep.h"

namespace mimo::receptors {

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

}  // namespace mimo::receptors
