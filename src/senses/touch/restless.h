// The sensors of a skin that are not at rest, with columns of their numbers, side by side: only they cost anything, and
// loops over them run through rows of memory.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

namespace mimo::senses::touch {

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

}  // namespace mimo::senses::touch
