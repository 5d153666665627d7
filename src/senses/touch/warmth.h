// How warm a skin is, sensor by sensor, and what its cold and warm receptors tell.
#pragma once

#include "base/bytes.h"
#include "receptors/skin_temperature.h"
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

}  // namespace mimo::senses::touch
