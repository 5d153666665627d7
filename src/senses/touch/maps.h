// The skin around each sensor, laid out flat.
#pragma once

#include <cstddef>
#include <vector>

#include "base/span.h"
#include "senses/touch/sensors.h"

namespace mimo::senses::touch {

// Distances along the skin are what decides who feels a touch. So each sensor keeps a small map of its surroundings:
// its neighbours' places on the skin as if it were unrolled around the sensor (a discrete exponential map, after
// Schmidt, Grimm and Wyvill 2006). The other side of a thin part, near through the air, is far away on that map.

// A sensor's place on another's map.
struct Neighbour {
  int sensor;
  float x, y;  // along the map owner's first and second tangent, m
};

// Of the maps that the process keeps.
std::size_t kept_map_bytes();

class Maps {
 public:
  // Adds the maps of a body's sensors, which are numbered from `first` on. A map reaches `reach` along the skin. Those
  // of the bodies that were added last, to any maps of the process, are not made again.
  void add(const BodySensors& skin, int first, double reach);

  // From the near to the far; the first is the sensor itself.
  Span<const Neighbour> of(int sensor) const {
    const std::size_t begin = starts_[static_cast<std::size_t>(sensor)];
    return {neighbours_.data() + begin, starts_[static_cast<std::size_t>(sensor) + 1] - begin};
  }
  std::size_t largest() const { return largest_; }

 private:
  std::vector<std::size_t> starts_{0};
  std::vector<Neighbour> neighbours_;
  std::size_t largest_ = 0;
};

}  // namespace mimo::senses::touch
