// A voice: vocal folds that swing, and the tube above them that rings (source and filter).
#pragma once

#include <array>
#include <cstdint>

#include "base/bytes.h"
#include "base/span.h"

namespace mimo::sound {

constexpr std::size_t kFormants = 3;
constexpr double kCry = 0.2518;  // Pa as root of the mean square at 1 m, of the loudest voice: 82 dB, an estimate

// What a voice is told.
struct Utterance {
  double loudness = 0;  // 0 to 1: pressure grows with its square
  double pitch = 0;     // octaves above the voice's own
  double opening = 1;   // times the first formant
  double front = 1;     // times the second one
};

class Vocal {
 public:
  // Its own pitch and formants, Hz; it gives `samples` of `rate` a second at a time. `number` tells voices apart.
  Vocal(double pitch, const std::array<double, kFormants>& formants, double rate, std::size_t samples,
        std::uint64_t number);

  void rest();
  // What it gives next: Pa at 1 m. False where that is silence, and nothing is written.
  bool utter(const Utterance& told, Span<float> out);

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  // y = gain x + near y' + far y''
  struct Resonator {
    double gain = 1, near = 0, far = 0;
  };

  bool silent() const;
  void move(const Utterance& told);
  std::array<Resonator, kFormants> resonators() const;
  double loudness_of_one(const std::array<Resonator, kFormants>& tract, double pitch) const;
  double fold(double step);
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit);

  double pitch_;
  std::array<double, kFormants> formants_;
  double rate_, approach_;
  std::uint64_t number_;
  // State.
  Utterance now_;  // what its muscles have come to
  double amplitude_ = 0, phase_ = 0;
  std::uint64_t cycle_ = 0;
  std::array<double, 2 * kFormants> memory_{};
};

}  // namespace mimo::sound
