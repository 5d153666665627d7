// Two bodies slide or roll on each other: noise of their surfaces.
#pragma once

#include <cstdint>

#include "base/bytes.h"
#include "base/span.h"
#include "sound/impact.h"

namespace mimo::sound {

constexpr double kSlowestScrape = 0.02;   // m/s: what rests creeps more slowly
constexpr double kFaintestScrape = 2e-4;  // Pa at 1 m, 20 dB: weaker noise of two bodies is none

// How they move against each other where they touch.
struct Sliding {
  double speed = 0;  // of sliding, or of rolling: m/s
  double force = 0;  // that presses them together, N
  bool rolls = false;
};

// The noise at 1 m: root of the mean square in Pa before what rolling takes of it, and above which frequency it takes.
struct ScrapeLevel {
  double pressure = 0;
  double corner = 0;  // Hz; 0: none
};
// Silence below the slowest speed, and of what does not ring.
ScrapeLevel scrape_level(const Struck& a, const Struck& b, const Sliding& sliding);

// The course of a noise: a random height for every 0.05 mm, read as fast as the bodies slide (van den Doel, Kry and
// Pai 2001). Slow sliding is dull, fast sliding is bright.
class ScrapeNoise {
 public:
  void rest(std::uint64_t number);  // starts anew; numbers tell noises apart
  // What comes next; false where that is silence, and nothing is written.
  bool sound(const ScrapeLevel& level, double speed, double rate, Span<float> out);

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  std::uint64_t number_ = 0;
  double distance_ = 0;  // in steps of the surface
  double speed_ = 0, pressure_ = 0, smooth_ = 0, corner_ = 0;
};

}  // namespace mimo::sound
