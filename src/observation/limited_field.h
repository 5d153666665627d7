// One field of the observation as an infant with lesser senses has it: weaker, blurred, late, noisy.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "observation/delay_line.h"
#include "observation/eyesight.h"
#include "observation/field.h"
#include "observation/foveation.h"

namespace mimo::observation {

struct Limits {
  double gain = 1;          // factor
  double noise = 0;         // standard deviation, in the field's unit; levels of 255 for colours
  double blur = 0;          // cycles per degree of which half the contrast is left; 0: sharp
  double delay = 0;         // seconds
  double signal_noise = 0;  // standard deviation, as a share of the value

  bool any() const { return gain != 1 || noise != 0 || blur != 0 || delay != 0 || signal_noise != 0; }
  bool noisy() const { return noise != 0 || signal_noise != 0; }
  // Of the noise of a value.
  double deviation(double value) const;
};

// An infant's natural limits: how late each element of a field comes, in seconds, one number where all come
// together, empty where none is late; and how well it sees, of pictures in colour.
struct Nature {
  std::vector<double> delays;
  Eyesight eyes;

  bool any() const { return !delays.empty() || eyes.any(); }
};

class LimitedField {
 public:
  // The field outlives this object. Where limits have a delay, it counts instead of those of nature. Throws where
  // limits make no sense for the field: blur of what is no picture, a delay of too many steps.
  LimitedField(const Field& field, const Limits& limits, const Nature& nature, const Clock& clock);

  const Field& field() const { return field_; }
  const DelayLine& delay() const { return delay_; }
  bool late() const { return delay_.late(); }
  // Whether what is seen depends on the pictures before.
  bool flickers() const { return eye_ && eye_->remembers(); }

  // What the receptors make of it at a tick of the episode, before it travels.
  enum class Memory { kKeep, kLeave };
  void weaken(std::uint8_t* block, std::uint64_t tick, Memory memory);
  // Noise is that of the moment when it arrives; equal seeds of an episode give equal noise.
  void disturb(std::uint8_t* block, std::uint64_t episode, std::uint64_t tick) const;
  DelayLine& delay() { return delay_; }
  void forget();
  // What it remembers.
  void list(std::vector<Section>& sections);

 private:
  void see(std::uint8_t* rgb, std::uint64_t tick, Memory memory);
  void forget_sight();
  Section sight();
  template <typename T>
  void scale(T* values) const;
  template <typename T>
  void add_noise(T* values, std::uint64_t seed) const;
  // What comes out stays between the bounds that the field promises, and is a number that its type has: a field without
  // bounds ends at the largest one.
  template <typename T>
  T bounded(double value) const;

  const Field& field_;
  Limits limits_;
  DelayLine delay_;
  double tick_;  // seconds
  std::optional<EyeFilter> eye_;
  std::uint64_t seen_at_ = 0;  // the tick of the picture that it remembers
  std::optional<Foveation> fovea_;
};

}  // namespace mimo::observation
