// Keeps from nerves how the solver makes sliding contacts hop. MuJoCo's friction is soft: a surface that slides at w
// with a friction of mu presses its contact apart at up to mu w, however small the steps and however well the solver
// has converged. What slides therefore hops: it is in the air for up to 2 mu w / g, falls back, and presses so much
// harder that the mean over a hop is the force with which it is held. Nothing of that is in the world.
//
// A contact that slides and opens is not believed for as long as a hop may take: its sensors are told of the mean force
// then, until it has stopped hopping. Contacts that open without sliding, stay open for longer, close, or change
// without opening are told as they are.
#pragma once

#include <cmath>

#include "observation/process.h"
#include "senses/touch/felt.h"
#include "senses/touch/restless.h"

namespace mimo::senses::touch {

class Rattle : public observation::Process {
 public:
  // `things` is how many the model has; `tick` is the time from one advance to the next, s.
  Rattle(std::size_t sensors, std::size_t things, double tick);

  // What each sensor feels at this tick, and its force as skin has smoothed it, by sensor.
  template <typename Smoothed>
  void advance(const Felt& felt, Smoothed&& smoothed) {
    take_in(felt);
    for (std::size_t i = table_.size(); i-- > 0;) {
      settle(i, felt.of(table_.sensors()[i]), smoothed(static_cast<std::size_t>(table_.sensors()[i])));
    }
  }
  void clear() { table_.clear(); }

  // Calls take(sensor, force) for all whose smoothed force may not be the one to believe; this one is, N.
  template <typename Take>
  void tell(Take&& take) const {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      take(static_cast<std::size_t>(table_.sensors()[i]), table_[kTold][i]);
    }
  }
  // Whether a sensor is told of another force than it feels.
  bool doubts(std::size_t sensor) const { return table_.number(kDoubt, sensor) > 0; }
  // Calls take(sensor, pressure) for those of them that something pricks, by Hertz with the force they are told of, Pa.
  template <typename Take>
  void prick(Take&& take) const {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      if (!(table_[kDoubt][i] > 0 && table_[kSharpness][i] > 0 && table_[kTold][i] > 0)) continue;
      take(table_.sensors()[i], table_[kSharpness][i] * std::cbrt(table_[kTold][i]));
    }
  }
  // What slides over a sensor, also while it hops: which of things.h, -1 for none, and how fast, m/s.
  struct Slide {
    double speed;
    int other;
  };
  Slide slide(std::size_t sensor) const;

  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  static constexpr std::size_t kStages = 3;
  enum Column : std::size_t {
    kMean,                     // force in the mean, N, after each stage of a filter
    kDoubt = kMean + kStages,  // time for which it is yet told, s
    kAir,                      // time for which it may yet be in the air, s
    kSpeed,                    // of what slides, m/s
    kOther,                    // and which thing it is
    kSharpness,                // of what pricks: its pressure over the cube root of the force, Pa
    kStates,                   // those above are remembered
    kTold = kStates,           // N
    kColumns
  };

  void rest(const mjModel&, const mjData&) override { clear(); }
  void go_on(const mjModel&, const mjData&) override {}
  void take_in(const Felt& felt);
  double& sharpness(int sensor) {
    return table_[kSharpness][static_cast<std::size_t>(table_.place(static_cast<std::size_t>(sensor)))];
  }
  void settle(std::size_t place, const Feeling& feeling, double smoothed);

  double things_, tick_, kept_;
  Restless<kColumns> table_;
};

}  // namespace mimo::senses::touch
