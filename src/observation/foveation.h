// Pictures that show their middle large and their rim small, as an eye's fovea does.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/pinhole.h"
#include "observation/contrast.h"
#include "observation/field.h"

namespace mimo::observation {

// Where the pixels of a foveated picture lie: its middle is large, its rim small, as an eye's fovea has it.

// What lies r pixels from the middle of the foveated picture is in the plain one R ((1 + strength)^(r / R) - 1) /
// strength from it, R being how far the corners are. The middle gets strength / ln(1 + strength) times as large: 4.2
// times for 10.
class FovealMap {
 public:
  // The plain picture is taken through the pinhole. Strengths are 0, where both are alike, or above.
  FovealMap(std::size_t height, std::size_t width, const Pinhole& pinhole, double strength);

  // Places are counted from the middle of the first pixel on, x to the right, y down.
  using Place = std::array<double, 2>;
  // As a vector of length 1: x right, y up, z back.
  std::array<double, 3> direction(Place foveated) const;
  // Of a direction, maybe beyond the picture's edges; none where it does not point forwards, or where all rays are
  // parallel.
  std::optional<Place> place(const std::array<double, 3>& direction) const;
  Place plain(Place foveated) const;
  Place foveated(Place plain) const;

  // How many plain pixels one is wide, r pixels from the middle.
  double shrinkage(double r) const;
  // Pixels from the middle to the corners.
  double corner() const { return corner_; }
  double distance(Place place) const;  // from the middle

 private:
  bool even() const { return strength_ <= 0 || corner_ == 0; }
  Place scaled(Place place, double factor) const;

  double strength_;
  double middle_x_, middle_y_, corner_;  // pixels
  Pinhole pinhole_;
};

// Of a picture that is a field.
FovealMap map_of(const Field& picture);

// It has no more detail than the plain picture had.
class Foveation {
 public:
  Foveation(std::size_t height, std::size_t width, const FovealMap& map);

  // Changes height x width x 3 bytes in place.
  void filter(std::uint8_t* rgb);

 private:
  // A picture of the old one's size divided by 2, 4, ...: red, then green, then blue.
  struct Level {
    std::size_t height, width;
    std::vector<Light> light;
  };
  // In 256ths: where a new pixel comes from in the old picture, and between which levels.
  struct Source {
    std::int32_t x, y;
    std::uint32_t level;
  };

  Source source(std::size_t x, std::size_t y) const;
  void read(const std::uint8_t* rgb);
  void sample(const Source& source, Light* out) const;
  void add(const Source& source, std::size_t number, std::uint32_t share, std::uint32_t* sum) const;

  std::size_t height_, width_;
  FovealMap map_;
  std::vector<Source> sources_;
  std::vector<Level> levels_;
  std::vector<Light> row_;  // room for one row of each colour
};

}  // namespace mimo::observation
