// The touch afferents of a skin, sensor by sensor: SA1, RA, PC, SA2. Forces are smoothed first, as contacts of physics
// chatter.
#pragma once

#include "base/bytes.h"
#include "senses/touch/felt.h"
#include "senses/touch/patches.h"
#include "senses/touch/restless.h"
#include "senses/touch/things.h"

namespace mimo::senses::touch {

class Afferents {
 public:
  Afferents(const std::vector<Patch>& patches, double slip_threshold, double tick);

  void rest(const Felt& felt);
  void go_on(const Felt& felt);
  // Brings the rates up to date; only who looks at them pays for it. What is felt is that of the last go_on.
  void tell(const Felt& felt, const Things& things);

  // Hz, by sensor; two directions each of SA2.
  const std::vector<float>& sa1() const { return sa1_; }
  const std::vector<float>& ra() const { return ra_; }
  const std::vector<float>& pc() const { return pc_; }
  const std::vector<float>& sa2() const { return sa2_; }

  const std::vector<int>& restless() const { return restless_.all(); }
  double force(std::size_t sensor) const { return states_[sensor].normal; }  // smoothed, N

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  struct State {
    double normal = 0, along = 0, across = 0;  // smoothed forces, N
    double depth = 0, speed = 0;               // m, m/s
    double jolts = 0;                          // envelope of PC, Hz
  };
  bool update(std::size_t sensor, const Feeling& feeling);
  void tell(std::size_t sensor, const Feeling& feeling, const Things& things);

  const std::vector<Patch>& patches_;
  double slip_threshold_, tick_, kept_;
  std::vector<State> states_;
  std::vector<float> sa1_, ra_, pc_, sa2_;
  Restless restless_;
};

}  // namespace mimo::senses::touch
