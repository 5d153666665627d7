// A field that comes late, each part of it by its own number of ticks.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/span.h"
#include "observation/field.h"

namespace mimo::observation {

// When histories take in what is sensed, and when it is asked for. A tick is a physics step of a world; a step has
// `per_step` of them, and only at its end is an observation wanted.
struct Clock {
  double tick = 0.01;          // seconds
  std::size_t per_step = 1;    // ticks
  bool within_a_step = false;  // whether anything can be sensed at ticks that end no step
};

// Consecutive elements of the flattened field that are equally late.
struct Run {
  std::size_t first, count;
  std::size_t ticks;
};

// How late each element of a field is; without runs none is.
struct Lateness {
  double tick = 0;  // seconds
  std::vector<Run> runs;

  std::size_t least() const;  // ticks
  std::size_t most() const;
  // In seconds, of each element.
  void tell(Span<double> seconds) const;
};

class DelayLine {
 public:
  // How late each element is, in seconds, or one number for all of them: the nearest number of ticks, or of steps where
  // nothing is sensed within them. Throws for more than 2000 of these. The field outlives this object.
  DelayLine(const Field& field, const std::vector<double>& seconds, const Clock& clock);

  bool late() const { return !past_.empty(); }
  const Lateness& lateness() const { return lateness_; }

  // Whether what is sensed at this tick of an episode will be asked for.
  bool wants(std::uint64_t tick) const { return (tick + phase_) % stride_ == 0; }
  bool begun() const { return begun_; }

  // Nothing was sensed before what the block holds.
  void begin(const std::uint8_t* block);
  // Keeps what the block holds as that of this tick; the first that is kept since `forget` is all that there is.
  void keep(const std::uint8_t* block, std::uint64_t tick);
  // Puts what was sensed before into the block; where nothing was, the block stays. Ticks that end a step only.
  void recall(std::uint8_t* block, std::uint64_t tick) const;
  void forget() { begun_ = false; }

  // What it remembers. This object outlives it and stays where it is.
  Section section();

 private:
  void add(std::size_t elements, std::size_t ticks);
  void choose_ticks(std::size_t per_step);
  std::size_t row(std::uint64_t number) const { return static_cast<std::size_t>(number % rows_) * field_->bytes(); }

  const Field* field_;
  Lateness lateness_;
  // A row is kept at each tick with (tick + phase) % stride == 0.
  std::size_t stride_ = 1, phase_ = 0, rows_ = 1;
  bool begun_ = false;  // something was sensed
  std::vector<std::uint8_t> past_;
};

}  // namespace mimo::observation
