// One field of the observation as an infant with lesser senses has it: weaker, blurred, noisy, late.
#pragma once

#include <cstdint>
#include <vector>

#include "base/section.h"
#include "observation/field.h"

namespace mimo::observation {

struct Limits {
  double gain = 1;   // factor
  double noise = 0;  // standard deviation, in the field's unit; levels of 255 for colours
  double blur = 0;   // cycles per degree of which half the contrast is left; 0: sharp
  double delay = 0;  // seconds

  bool any() const { return gain != 1 || noise != 0 || blur != 0 || delay != 0; }
};

class LimitedField {
 public:
  // The field outlives this object; steps are `step` seconds long. Throws where limits make no sense for it: blur of
  // what is no picture, a delay of too many steps.
  LimitedField(const Field& field, const Limits& limits, double step);

  const Field& field() const { return field_; }
  std::size_t delay() const { return delay_; }  // steps
  bool late() const { return delay_ > 0; }

  // Changes the field in the block; equal seeds of an episode give equal noise.
  void weaken(std::uint8_t* block, std::uint64_t episode, std::uint64_t step);

  // Nothing was sensed before what the block holds.
  void begin(const std::uint8_t* block);
  // Keeps what the block holds as that of this step; the first that is kept since `forget` is all that there is.
  void keep(const std::uint8_t* block, std::uint64_t step);
  // Puts what was sensed `delay` before this step into the block; where nothing was, the block stays.
  void recall(std::uint8_t* block, std::uint64_t step) const;
  void forget() { begun_ = false; }

  // What it remembers, for one that is late. This object outlives it and stays where it is.
  Section section();

 private:
  template <typename T>
  void scale_and_add_noise(T* values, std::uint64_t seed) const;
  std::uint8_t* slot(std::uint64_t step) { return past_.data() + slot_offset(step); }
  std::size_t slot_offset(std::uint64_t step) const;

  const Field& field_;
  Limits limits_;
  std::size_t delay_ = 0;           // steps
  bool begun_ = false;              // something was sensed
  std::vector<float> kernel_;       // of the blur: from its middle outwards
  std::vector<float> rows_;         // room for a picture blurred in one direction
  std::vector<std::uint8_t> past_;  // the last delay + 1 times the field
};

}  // namespace mimo::observation
