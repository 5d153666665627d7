// Fast and slow nociceptors of a skin, sensor by sensor.
#pragma once

#include "senses/touch/warmth.h"

namespace mimo::senses::touch {

class Pain {
 public:
  enum Rate : std::size_t { kFast, kSlow };  // Hz

  Pain(const std::vector<Patch>& patches, double tick);

  void rest() { table_.clear(); }
  // What slides pricks as it rattles.
  void go_on(const Felt& felt, const Rattle& rattle, const Warmth& warmth);

  // Fills a rate in where a sensor is not at rest: there it is 0.
  void fill_in(Rate rate, float* out) const { table_.spread(kFirstRate + std::size_t{rate}, out); }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  enum Column : std::size_t {
    kOver,     // the greatest pressure of this step, in units of the threshold
    kAdapted,  // of the fast ones to pressure, 0 to 1
    kFirstRate,
    kColumns = kFirstRate + 2
  };
  void prick(int sensor, double pressure);
  // Says whether the sensor goes on being restless.
  bool update(std::size_t place, double temperature);

  const std::vector<Patch>& patches_;
  double kept_;
  Restless<kColumns> table_;
};

}  // namespace mimo::senses::touch
