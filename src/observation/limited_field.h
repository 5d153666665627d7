// One field of the observation as an infant with lesser senses has it: weaker, blurred, noisy, late.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "observation/field.h"

namespace mimo::observation {

struct Limits {
  double gain = 1;   // factor
  double noise = 0;  // standard deviation, in the field's unit; levels of 255 for colours
  double blur = 0;   // cycles per degree of which half the contrast is left; 0: sharp
  int delay = 0;     // steps

  bool any() const { return gain != 1 || noise != 0 || blur != 0 || delay != 0; }
};

class LimitedField {
 public:
  // The field outlives this object. Throws where limits make no sense for it: blur of what is no picture.
  LimitedField(const Field& field, const Limits& limits);

  const Limits& limits() const { return limits_; }

  // Changes the field in the block; equal seeds give equal noise.
  void weaken(std::uint8_t* block, std::uint64_t seed);

  // Nothing was sensed before what the block holds.
  void begin(const std::uint8_t* block);
  // Keeps what the block holds as that of this step.
  void keep(const std::uint8_t* block, std::uint64_t step);
  // Puts what was sensed `delay` steps before this one into the block.
  void recall(std::uint8_t* block, std::uint64_t step) const;

  void save(ByteWriter& to) const { to.put(Span<const std::uint8_t>(past_)); }
  void load(ByteReader& from) { from.take(Span<std::uint8_t>(past_)); }

 private:
  template <typename T>
  void scale_and_add_noise(T* values, std::uint64_t seed) const;
  std::uint8_t* slot(std::uint64_t step) { return past_.data() + slot_offset(step); }
  std::size_t slot_offset(std::uint64_t step) const;

  const Field& field_;
  Limits limits_;
  std::vector<float> kernel_;       // of the blur: from its middle outwards
  std::vector<float> rows_;         // room for a picture blurred in one direction
  std::vector<std::uint8_t> past_;  // the last delay + 1 times the field
};

}  // namespace mimo::observation
