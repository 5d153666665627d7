// Contrasts in bands of an octave, and pictures without those that are too faint to be seen (after Peli 1990).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mimo::observation {

class Bands {
 public:
  // How many bands a picture has: so many that the coarsest has 16 pixels a side.
  static std::size_t number(std::size_t height, std::size_t width);
  // Cycles per pixel in the middle of a band, 0 being the finest. Of a grating of so many, along rows or columns,
  // nothing is in another band; of a slanted one some is in the next coarser.
  static double middle(std::size_t band);

  Bands() = default;
  // The least contrast that is seen in each band.
  Bands(std::size_t height, std::size_t width, const std::vector<double>& least);

  bool any() const { return !levels_.empty(); }
  // Changes height x width of light, 0 for black. Where a band has too little contrast to what is coarser than it, and
  // all around as well, it is gone; elsewhere it stays as it is.
  void clear_unseen(float* light);

 private:
  // What pictures hold at a scale.
  struct Level {
    std::size_t height, width;
    float least;                      // contrast that is seen
    std::vector<float> light;         // without finer bands
    std::vector<float> coarse;        // nor this one
    std::vector<float> change;        // what becomes of the light
    std::vector<std::uint8_t> seen;   // 0 or 1
    std::vector<std::uint8_t> along;  // some is seen near in the row
  };

  void halve(const Level& from, Level& to);
  void enlarge(const std::vector<float>& small, const Level& from, const Level& to, std::vector<float>& large);
  void find_seen(Level& level);

  std::vector<Level> levels_;  // from fine to coarse; of the last one nothing is taken
  std::vector<float> room_;    // for a picture halved or enlarged one way
  std::vector<float> row_;     // a row, with what it is taken for beyond its edges
};

}  // namespace mimo::observation
