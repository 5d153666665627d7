#include "growth/hearing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "growth/points.h"

namespace mimo::growth {
namespace {

constexpr std::size_t kFrequencies = 7;  // octaves from 125 Hz on
constexpr double kLowest = 125;

// Of adults (ISO 226:2003), dB of 20 uPa.
constexpr std::array<double, kFrequencies> kAdult = {22.1, 11.4, 4.4, 2.4, -1.3, -5.4, 12.6};

// By how much infants' are higher, dB. Anchors are Sinnott 1983 (newborns at 500 and 4000 Hz), Olsho 1988 (3 months at
// 1 and 8 kHz), Nozza and Wilson 1984 and Parry (6 and 12 months); what lies between them is an estimate, and so is all
// at 24 months. Behaviour includes attention: the ears themselves are better than this, most of all those of newborns.
constexpr Point kAbove[kFrequencies][5] = {
    {{0, 48}, {3, 24}, {6, 16}, {12, 16}, {24, 14}}, {{0, 47}, {3, 22}, {6, 15}, {12, 15}, {24, 12}},
    {{0, 45}, {3, 18}, {6, 15}, {12, 14}, {24, 10}}, {{0, 40}, {3, 16}, {6, 14}, {12, 12}, {24, 8}},
    {{0, 36}, {3, 17}, {6, 11}, {12, 8}, {24, 6}},   {{0, 32}, {3, 20}, {6, 8}, {12, 6}, {24, 4}},
    {{0, 40}, {3, 30}, {6, 10}, {12, 8}, {24, 4}},
};

double at_octave(double age, std::size_t octave) {
  const Stretch at = stretch_at(kAbove[octave], age);
  return kAdult[octave] + at.left + (at.right - at.left) * at.share;
}

}  // namespace

double hearing_threshold(double age, double frequency) {
  const double octave = std::clamp(std::log2(frequency / kLowest), 0.0, kFrequencies - 1.0);
  const std::size_t below = std::min(static_cast<std::size_t>(octave), kFrequencies - 2);
  const double share = octave - static_cast<double>(below);
  return (1 - share) * at_octave(age, below) + share * at_octave(age, below + 1);
}

}  // namespace mimo::growth
