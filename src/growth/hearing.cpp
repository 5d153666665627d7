#include "growth/hearing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "growth/points.h"

namespace mimo::growth {
namespace {

constexpr std::size_t kFrequencies = 7;  // octaves from 125 Hz on
constexpr double kLowest = 125;

// Of adults (ISO 226:2003), dB of 20 uPa: at the octaves, and at the middles of the bands that are heard.
struct Threshold {
  double frequency, level;
};
constexpr Threshold kAdult[] = {
    {100, 26.5},    {125, 22.1},    {147.7, 19.3},  {202.4, 14.2}, {250, 11.4},    {265, 10.7},    {336.7, 7.9},
    {418.8, 5.8},   {500, 4.4},     {512.8, 4.2},   {620.4, 3.1},  {743.7, 2.4},   {884.9, 2.3},   {1000, 2.4},
    {1046.6, 2.6},  {1231.7, 3.4},  {1443.7, 2.4},  {1686.5, 1.0}, {1964.6, -1.1}, {2000, -1.3},   {2283, -3.0},
    {2647.6, -4.6}, {3065.1, -5.8}, {3543.3, -5.7}, {4000, -5.4},  {4090.8, -5.0}, {4717.9, -2.5}, {5436, 1.2},
    {6258.3, 5.8},  {7200, 9.7},    {8000, 12.6}};

// By how much infants' are higher, dB. Anchors are Sinnott 1983 (newborns at 500 and 4000 Hz), Olsho 1988 (3 months at
// 1 and 8 kHz), Nozza and Wilson 1984 and Parry (6 and 12 months); what lies between them is an estimate, and so is all
// at 24 months. Behaviour includes attention: the ears themselves are better than this, most of all those of newborns.
constexpr Point kAbove[kFrequencies][5] = {
    {{0, 48}, {3, 24}, {6, 16}, {12, 16}, {24, 14}}, {{0, 47}, {3, 22}, {6, 15}, {12, 15}, {24, 12}},
    {{0, 45}, {3, 18}, {6, 15}, {12, 14}, {24, 10}}, {{0, 40}, {3, 16}, {6, 14}, {12, 12}, {24, 8}},
    {{0, 36}, {3, 17}, {6, 11}, {12, 8}, {24, 6}},   {{0, 32}, {3, 20}, {6, 8}, {12, 6}, {24, 4}},
    {{0, 40}, {3, 30}, {6, 10}, {12, 8}, {24, 4}},
};

double above_adult(double age, std::size_t octave) {
  const Stretch at = stretch_at(kAbove[octave], age);
  return at.left + (at.right - at.left) * at.share;
}

// Straight lines over the logarithm of frequency; the first and last value beyond.
double adult(double frequency) {
  const auto lower = [](double f, const Threshold& point) { return f < point.frequency; };
  const auto right = std::upper_bound(std::begin(kAdult), std::end(kAdult), frequency, lower);
  if (right == std::begin(kAdult)) return right->level;
  const auto left = right - 1;
  if (right == std::end(kAdult)) return left->level;
  const double share = std::log(frequency / left->frequency) / std::log(right->frequency / left->frequency);
  return left->level + share * (right->level - left->level);
}

}  // namespace

double hearing_threshold(double age, double frequency) {
  const double octave = std::clamp(std::log2(frequency / kLowest), 0.0, kFrequencies - 1.0);
  const std::size_t below = std::min(static_cast<std::size_t>(octave), kFrequencies - 2);
  const double share = octave - static_cast<double>(below);
  return adult(frequency) + (1 - share) * above_adult(age, below) + share * above_adult(age, below + 1);
}

}  // namespace mimo::growth
