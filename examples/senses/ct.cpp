// C-tactile afferents: thin, slow nerves of hairy skin that fire at gentle stroking. A sense in one file, for
// mimo::Scene::load_sense or Scene.load_sense in Python. It needs touch/slip and touch/temperature.
//
// After Loken et al. 2009 (Nat Neurosci 12:547), Ackerley et al. 2014 (J Neurosci 34:2879) and Vallbo et al. 1999
// (J Neurophysiol 81:2753) and 2016: hairy skin only; at most 100 impulses a second; an inverted U over the speed of a
// stroke with its top between 1 and 10 cm/s, little at 0.3 and 30; most for a stroke of neutral warmth, 32 degrees
// Celsius, less at 18 and 42; strong fatigue; no nerve sheath, 0.9 m/s. The widths of both curves and the two times of
// fatigue are estimates.
#include <cmath>
#include <mimo/mimo.hpp>

namespace {

struct Afferent {
  float rate;    // Hz, smoothed
  float rested;  // 1: fresh, 0: exhausted
};

enum Parameter { kMost, kBestSpeed, kSpeedWidth, kBestTemperature, kTemperatureWidth, kTiring, kRecovery, kCount };

class CTactile : public mimo::Sense {
 public:
  static std::vector<mimo_parameter> parameters() {
    using mimo::sense_parameter;
    std::vector<mimo_parameter> all(kCount);
    all[kMost] = sense_parameter("most", "rate of a rested afferent at the best stroke, Hz", 60, 0, 100);
    all[kBestSpeed] = sense_parameter("best_speed", "speed at which it fires most, m/s", 0.03, 0.01, 0.1);
    all[kSpeedWidth] = sense_parameter("speed_width", "deviation of the curve over speed, decades", 0.55, 0.1, 3);
    all[kBestTemperature] = sense_parameter("best_temperature", "warmth of skin, degrees Celsius", 32.5, 20, 45);
    all[kTemperatureWidth] = sense_parameter("temperature_width", "deviation of that curve, degrees", 3, 0.5, 50);
    all[kTiring] = sense_parameter("tiring", "share of its strength that each impulse takes", 0.01, 0, 1);
    all[kRecovery] = sense_parameter("recovery", "time in which it rests, s", 30, 0.1, 1000);
    return all;
  }

  explicit CTactile(mimo::SenseOpening& opening) {
    const mimo::Layout layout = opening.world.layout();
    slip_ = layout.find(opening.own("touch/slip"));
    temperature_ = layout.find(opening.own("touch/temperature"));
    const std::vector<mimo::Receptor> skin = layout.receptors(opening.own("touch/slip"));
    mimo::SenseField field("", {}, "Hz");
    for (std::size_t i = 0; i < skin.size(); ++i) {
      if (is_hairy(opening.world.name(MIMO_BODY, skin[i].body)))
        field.receptors.push_back(static_cast<std::int32_t>(i));
    }
    if (field.receptors.empty()) throw std::runtime_error("the agent has no hairy skin with sensors");
    field.shape = {field.receptors.size()};
    field.skin = "touch/slip";
    field.low = 0;
    field.high = 100;
    field.nerve_speed = 0.9;
    opening.add(field);
    hairy_ = field.receptors;
    opening.memory_bytes = hairy_.size() * sizeof(Afferent);
  }

  void reset(const mimo::SenseMoment& now) const override {
    for (std::size_t i = 0; i < hairy_.size(); ++i) afferents(now)[i].rested = 1;
  }

  void advance(const mimo::SenseMoment& now) const override {
    const double *set = now.told.parameters, tick = now.told.timestep;
    const float *slip = now.feel(slip_), *temperature = now.feel(temperature_);
    const double kept = std::exp(-tick / 0.05), rests = tick / set[kRecovery];  // of 50 ms: contacts hop
    for (std::size_t i = 0; i < hairy_.size(); ++i) {
      Afferent& one = afferents(now)[i];
      const float* along = slip + 2 * hairy_[i];
      const double speed = std::hypot(along[0], along[1]);
      const double wanted = speed > 0 ? one.rested * stroke(set, speed, temperature[hairy_[i]]) : 0;
      one.rate = static_cast<float>(wanted + kept * (one.rate - wanted));
      one.rested += static_cast<float>((1 - one.rested) * rests - one.rested * set[kTiring] * one.rate * tick);
    }
  }

  void write(const mimo::SenseMoment& now) const override {
    for (std::size_t i = 0; i < hairy_.size(); ++i) now.field(0)[i] = std::min(afferents(now)[i].rate, 100.0f);
  }

 private:
  // Palms, soles, fingers and toes are glabrous, and so are lips and eyes; the backs of hands and feet, which are not,
  // are parts of the same bodies and are left out.
  static bool is_hairy(const std::string& body) {
    for (const char* bald :
         {"hand", "finger", "knuckle", "middle", "distal", "metacarpal", "_th", "foot", "toe", "eye"}) {
      if (body.find(bald) != std::string::npos) return false;
    }
    return true;
  }

  // Of a rested afferent, Hz.
  static double stroke(const double* set, double speed, double temperature) {
    const double decades = std::log10(speed / set[kBestSpeed]) / set[kSpeedWidth];
    const double off = (temperature - set[kBestTemperature]) / set[kTemperatureWidth];
    return set[kMost] * std::exp(-0.5 * decades * decades) * std::exp(-0.5 * off * off);
  }

  static Afferent* afferents(const mimo::SenseMoment& now) { return &now.memory<Afferent>(); }

  std::size_t slip_, temperature_;
  std::vector<std::int32_t> hairy_;  // receptors of touch/slip
};

}  // namespace

MIMO_SENSE(mimo::sense<CTactile>("ct"))
