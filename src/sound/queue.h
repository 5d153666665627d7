// Samples that a host plays, one after the other, and what of them is still on its way.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/span.h"

namespace mimo::sound {

// So many samples after the one that an ear just hears have to be there: what lies between samples follows from both
// sides.
constexpr std::int64_t kAhead = 4;
constexpr std::int64_t kInTheAir = 1024;  // samples: what is further away than 22 m at 16 kHz is not heard any more

class Queue {
 public:
  // For sounds up to so many samples.
  explicit Queue(std::size_t capacity) : ring_(capacity + static_cast<std::size_t>(kInTheAir), 0.0F) {}

  void clear();
  // How many samples may be added at this time.
  std::size_t room(std::int64_t now) const;
  // They are heard after what is there already, from now on at the earliest. There is room for them.
  void add(Span<const float> samples, std::int64_t now);
  // What is still to come is not played.
  void stop(std::int64_t now);
  // Everything is played and has passed every ear.
  bool over(std::int64_t now) const { return now >= end_ + kInTheAir; }

  // Sound at times first, first + 1, ... (in samples, and parts of one), added to `out` with gains that go in a
  // straight line from `gain` to `last_gain`.
  void read(double first, Span<float> out, float gain, float last_gain) const;

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  float sample(std::int64_t at) const;

  std::vector<float> ring_;
  std::int64_t begin_ = 0, end_ = -kInTheAir;  // what it holds
};

}  // namespace mimo::sound
