// Keeps from nerves how the solver makes sliding contacts hop. MuJoCo's friction is soft: a surface that slides at w
// with a friction of mu presses its contact apart at up to mu w, however small the steps and however well the solver
// has converged. What slides therefore hops: it is in the air for up to 2 mu w / g, falls back, and presses so much
// harder that the mean over a hop is the force with which it is held. Nothing of that is in the world.
//
// A contact that slides and opens is not believed for as long as a hop may take: its sensors are told of the mean force
// then, until it has stopped hopping. Contacts that open without sliding, stay open for longer, close, or change
// without opening are told as they are.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "base/functions.h"
#include "observation/sense.h"
#include "senses/touch/felt.h"

namespace mimo::senses::touch {

// The sensors of a skin that are not at rest, with columns of their numbers, side by side: only they cost anything, and
// loops over them run through rows of memory.

// What loops over columns go in: eight sensors at once.
using Row = Eigen::Array<double, 8, 1>;
constexpr std::size_t kRow = 8;

template <std::size_t kColumns>
class Restless {
 public:
  static constexpr int kNone = -1;

  // The last row is a whole one: beyond the last sensor are numbers of no meaning.
  explicit Restless(std::size_t sensors) : places_(sensors, kNone) {
    sensors_.reserve(sensors);
    for (std::vector<double>& column : columns_) column.resize(sensors + kRow - 1);
  }

  std::size_t size() const { return sensors_.size(); }
  std::size_t sensor_count() const { return places_.size(); }  // at rest or not
  const std::vector<int>& sensors() const { return sensors_; }
  // Of a sensor in the columns; kNone where it is at rest.
  int place(std::size_t sensor) const { return places_[sensor]; }
  bool has(std::size_t sensor) const { return places_[sensor] != kNone; }
  double* operator[](std::size_t column) { return columns_[column].data(); }
  const double* operator[](std::size_t column) const { return columns_[column].data(); }
  Eigen::Map<Row> row(std::size_t column, std::size_t first) { return Eigen::Map<Row>(&columns_[column][first]); }
  // Gives the last row's numbers beyond the last sensor one that has a meaning.
  void pad(std::size_t column, double number) {
    const std::size_t beyond = (kRow - sensors_.size() % kRow) % kRow;
    std::fill_n(&columns_[column][0] + sensors_.size(), beyond, number);
  }
  // 0 where it is at rest.
  double number(std::size_t column, std::size_t sensor) const {
    return places_[sensor] == kNone ? 0 : columns_[column][static_cast<std::size_t>(places_[sensor])];
  }

  // The place of a sensor, with zeros where it had none.
  std::size_t add(int sensor) {
    int& place = places_[static_cast<std::size_t>(sensor)];
    if (place != kNone) return static_cast<std::size_t>(place);
    const std::size_t made = sensors_.size();
    for (std::vector<double>& column : columns_) column[made] = 0;
    place = static_cast<int>(made);
    sensors_.push_back(sensor);
    return made;
  }
  // The last one takes its place: who removes some on the way goes from the last to the first.
  void remove(std::size_t place) {
    const std::size_t last = sensors_.size() - 1;
    places_[static_cast<std::size_t>(sensors_[last])] = static_cast<int>(place);
    places_[static_cast<std::size_t>(sensors_[place])] = kNone;
    sensors_[place] = sensors_[last];
    for (std::vector<double>& column : columns_) column[place] = column[last];
    sensors_.pop_back();
  }
  void clear() {
    for (const int sensor : sensors_) places_[static_cast<std::size_t>(sensor)] = kNone;
    sensors_.clear();
  }

  // A column as all sensors have it: 0 at rest. Every so many numbers one of them.
  void spread(std::size_t column, float* out, std::size_t every = 1) const {
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      out[static_cast<std::size_t>(sensors_[i]) * every] = static_cast<float>(columns_[column][i]);
    }
  }

 private:
  std::vector<int> places_, sensors_;
  std::array<std::vector<double>, kColumns> columns_;
};

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
  // Whether a sensor reports another force than it feels.
  bool doubts(std::size_t sensor) const { return table_.number(kDoubt, sensor) > 0; }
  // Calls take(sensor, pressure) for those of them that something pricks, by Hertz with the force they are told of, Pa.
  template <typename Take>
  void prick(Take&& take) const {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      if (!(table_[kDoubt][i] > 0 && table_[kSharpness][i] > 0 && table_[kTold][i] > 0)) continue;
      take(table_.sensors()[i], table_[kSharpness][i] * fixed::cbrt(table_[kTold][i]));
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
