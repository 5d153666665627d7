// Which reflexes there are, what is known of each, and what is not.
//
// Sources. Starts of the grasps and of Moro: Futagi, Toribe and Suzuki 2012 (Int J Pediatr 2012:191562). Withdrawal:
// Andrews and Fitzgerald 1994 (Pain 56:95), Kuhne et al. 2012, Cornelissen et al. 2013. The other starts, and all ends,
// are those of textbooks, which differ by a month or two. Thresholds but that of withdrawal, times, amplitudes and
// habituation are estimates: they were not found measured in infants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "growth/maturity.h"

namespace mimo::reflexes {

enum class Reflex : int { kPalmarGrasp, kPlantarGrasp, kRooting, kMoro, kTonicNeck, kStepping, kWithdrawal };
constexpr std::size_t kReflexes = 7;

enum class Side : int { kLeft, kRight };
constexpr std::size_t kSides = 2;
constexpr const char* kSideNames[kSides] = {"left", "right"};

constexpr double kNever = std::numeric_limits<double>::infinity();

// Where it is switched: how long that takes is estimated.
constexpr double kSpinal = 0.012, kBrainStem = 0.025;  // s

struct Rule {
  std::uint32_t bit;  // of the header
  const char* name;
  double start, end;   // months from birth at term; kNever: it stays
  double centre;       // s
  double threshold;    // of its stimulus, in the unit below
  double release;      // the share of the threshold at which a stimulus counts as gone
  const char* unit;    // of the stimulus
  bool tonic;          // it lasts as long as its stimulus; else for a time of its own
  double hold, decay;  // s; of a tonic one the least
  double amplitude;    // of what a motor can do
};

const Rule& rule(Reflex reflex);

// 1, in the last month falling to 0, outside of its ages 0.
double gain(const Rule& rule, double months);

// What its nerves take to conduct there and back, and its centre to switch, s. Metres from the place of the stimulus
// and from the motors to the brain stem.
double latency(const Rule& rule, const growth::Conduction& nerves, double sensory, double motor);

// N, on the sole: von Frey hairs that draw the leg back. Through the two ends that were measured: 1.2 g at 3 days, 4.6
// g at a year, and as then afterwards.
double withdrawal_force(double months);
// How much more it takes there than on the sole; estimated.
constexpr double kLowerLeg = 1.5, kThigh = 2;

// How much the other leg takes part in withdrawal: as much as the leg itself in newborns (Cornelissen et al. 2013), in
// the second and third month less and less; that is a guess.
double crossed(double months);

}  // namespace mimo::reflexes
