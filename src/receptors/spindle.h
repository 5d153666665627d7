// Muscle spindles: how long a muscle is and how fast it is stretched, as afferents Ia and II tell it, under the drive
// that its fusimotor neurons give it.
//
// The model of Mileusnic, Brown, Lan and Loeb 2006 (J Neurophysiol 96:1772) in a closed form: the polar region's length
// and speed follow those of the fibre. It is within 1 % of the full model at the end of a stretch, and lacks only the
// creep of some 0.2 s after it. Fitted to cats; nothing is known of infants.
#pragma once

namespace mimo::receptors {

// Spikes a second of the gamma neurons.
struct FusimotorDrive {
  double dynamic_rate = 70, static_rate = 70;
};

// How much the three kinds of fibre contract: what a drive does in the end, 0 to 1.
struct Fusimotion {
  explicit Fusimotion(const FusimotorDrive& drive);
  double bag1, bag2, chain;
};

struct SpindleRates {
  double primary, secondary;  // Ia and II, Hz
};

// Length in units of the optimal length L0, velocity in L0/s, positive where the muscle is stretched.
SpindleRates spindle(double length, double velocity, const Fusimotion& drive);

// The lengths of a joint's muscle at the two ends of the joint's range: an estimate, about the range that the model was
// fitted in.
constexpr double kShortestMuscle = 0.80, kLongestMuscle = 1.10;  // L0

}  // namespace mimo::receptors
