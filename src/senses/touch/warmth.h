// How warm a skin is, sensor by sensor, and what its cold and warm receptors tell.
#pragma once

#include "base/bytes.h"
#include "receptors/skin_temperature.h"
#include "senses/touch/afferents.h"

namespace mimo::senses::touch {

class Warmth {
 public:
  Warmth(const std::vector<Patch>& patches, double air, double tick);

  void rest();
  // `afferents` are those of the same tick: they know how hard each sensor is pressed.
  void go_on(const Felt& felt, const Afferents& afferents, const Things& things);

  // Brings the rates up to date; only who looks at them pays for it.
  void tell();

  const std::vector<float>& temperature() const { return temperature_; }  // degrees Celsius
  const std::vector<float>& cold() const { return cold_; }                // Hz
  const std::vector<float>& warm() const { return warm_; }
  const std::vector<int>& restless() const { return restless_.all(); }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  struct State {
    double surface, at_cold, at_warm;  // degrees; the latter two at the receptors
    double before = 0, since = 0;      // the surface when something began to touch it, and for how long it has, s
    int other = -1;                    // the geom that touches; -1: none
  };
  bool update(std::size_t sensor, int touching, double force, const Things& things);
  void tell(std::size_t sensor);

  const std::vector<Patch>& patches_;
  double rest_, tick_, kept_, kept_cold_, kept_warm_;
  std::vector<State> states_;
  std::vector<float> temperature_, cold_, warm_;
  Restless restless_;
};

}  // namespace mimo::senses::touch
