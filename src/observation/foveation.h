// Pictures that show their middle large and their rim small, as an eye's fovea does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "observation/foveal_map.h"
#include "observation/light.h"

namespace mimo::observation {

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
