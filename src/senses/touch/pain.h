// Fast and slow nociceptors of a skin, sensor by sensor.
#pragma once

#include "senses/touch/warmth.h"

namespace mimo::senses::touch {

class Pain {
 public:
  Pain(const std::vector<Patch>& patches, double tick);

  void rest();
  void go_on(const Felt& felt, const Warmth& warmth);

  const std::vector<float>& fast() const { return fast_; }  // Hz
  const std::vector<float>& slow() const { return slow_; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  bool update(std::size_t sensor, double temperature);

  const std::vector<Patch>& patches_;
  double kept_;
  std::vector<double> over_;     // the greatest pressure of this step, in units of the threshold
  std::vector<double> adapted_;  // of the fast ones to pressure, 0 to 1
  std::vector<float> fast_, slow_;
  Restless restless_;
};

}  // namespace mimo::senses::touch
