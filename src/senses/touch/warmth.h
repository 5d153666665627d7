// How warm a skin is, sensor by sensor, and what depends on it: cold and warm receptors, nociceptors, C-tactile
// afferents.
#pragma once

#include "base/bytes.h"
#include "receptors/skin.h"
#include "senses/touch/afferents.h"

namespace mimo::senses::touch {

class Warmth {
 public:
  Warmth(const std::vector<Patch>& patches, const Things& things, double tick);

  void rest();
  // `afferents` are those of the same tick: they know how hard each sensor is pressed.
  void go_on(const Felt& felt, const Afferents& afferents);

  // Brings what is told up to date; only who looks at it pays for it.
  void tell(bool rates);

  const std::vector<float>& temperature() const { return temperature_; }  // degrees Celsius, as it was told
  const std::vector<float>& cold() const { return cold_; }                // Hz
  const std::vector<float>& warm() const { return warm_; }

  // Of a sensor now, as nociceptors get it: degrees.
  float now(std::size_t sensor) const;
  // Calls see(sensor, degrees) for skin that is colder or warmer than these now, and maybe for some that is not.
  template <typename See>
  void beyond(double coldest, double warmest, See&& see) const {
    if (coldest_ >= coldest && warmest_ <= warmest) return;
    for (std::size_t i = 0; i < touched_.size(); ++i) see(touched_.sensors()[i], as_told(touched_[kSurface][i]));
    for (std::size_t i = 0; i < free_.size(); ++i) see(free_.sensors()[i], as_told(free_[kSurface][i]));
  }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  enum Column : std::size_t {
    kSurface,  // degrees; the next two at the receptors
    kAtCold,
    kAtWarm,
    kFreeColumns,
    // Of what is touched: how it began, for how long it has been, s, and the number of the geom that touches.
    kBefore = kFreeColumns,
    kSwing,
    kPace,
    kSince,
    kOther,
    kColumns
  };
  using Touched = Restless<kColumns>;
  using Free = Restless<kFreeColumns>;

  static float as_told(double degrees) { return static_cast<float>(degrees); }

  void touch(int sensor, int other);
  void begin(std::size_t place, int other, double before);
  void let_go(std::size_t place);
  void follow_things();
  void come_back();
  template <typename Table>
  void tell(const Table& table, bool rates);
  void tell_rest(std::size_t sensor);

  const Things& things_;
  double rest_, tick_, kept_, kept_cold_, kept_warm_;
  std::vector<float> factors_;  // of the rates
  float cold_at_rest_, warm_at_rest_;
  Touched touched_;  // a sensor is here,
  Free free_;        // or here, or at rest
  double coldest_, warmest_;
  std::vector<float> temperature_, cold_, warm_;
};

// Fast and slow nociceptors of a skin, sensor by sensor.

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

// C-tactile afferents of a skin, sensor by sensor. Only hairy skin has any: neither hands and feet nor lips.

class Caresses {
 public:
  Caresses(const mjModel& model, const body::Body& body, const Skin& skin, const std::vector<Patch>& patches,
           double slip_threshold, double tick);

  void rest() { table_.clear(); }
  void go_on(const Felt& felt, const Afferents& afferents, const Warmth& warmth);

  // Fills the rate in where a sensor is not at rest, Hz: there it is 0.
  void fill_in(float* out) const { table_.spread(kRate, out); }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  enum Column : std::size_t { kFatigue, kRate, kDrive, kColumns };  // kDrive: the rate of fresh ones, in this tick

  std::vector<char> hairy_;  // by sensor
  double slip_threshold_, tick_;
  double kept_;  // share of the fatigue that a tick of rest leaves
  Restless<kColumns> table_;
};

}  // namespace mimo::senses::touch
