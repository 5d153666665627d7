// The light behind the levels of a picture, and its contrasts in bands of an octave.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mimo::observation {

// Light behind the levels of a picture: levels are coded for screens (sRGB), but it is light that adds up in an eye.

// Light in 16 bits. Below black and above white there is room for what rounding adds on the way.
using Light = std::uint16_t;
constexpr Light kBlack = 512;
constexpr Light kWhite = 32256;

using LightTable = std::array<Light, 256>;  // of levels

// Rows of pixels between bytes (red, green, blue of one pixel after the other) and rows of one colour's light. Tables
// rather than powers: these are faster, and whole numbers are the same on every machine.
class LightTables {
 public:
  LightTables();

  void decode(const std::uint8_t* rgb, std::size_t width, Light* red, Light* green, Light* blue) const;
  void encode(const Light* red, const Light* green, const Light* blue, std::size_t width, std::uint8_t* rgb) const;
  // Only the luminance: .2126 red + .7152 green + .0722 blue.
  void decode_grey(const std::uint8_t* rgb, std::size_t width, Light* grey) const;
  void encode_grey(const Light* grey, std::size_t width, std::uint8_t* rgb) const;

 private:
  // Four lights in a row are one level: the darkest levels are ten lights apart.
  std::uint32_t level(Light light) const { return level_[static_cast<unsigned>(light) >> 2]; }

  LightTable light_;
  LightTable red_, green_, blue_;               // their shares of the luminance
  std::array<std::uint32_t, 65536 / 4> level_;  // in each of its four bytes
};

extern const LightTables kLightTables;  // made when the library is loaded: 511 powers

// Takes colours towards their luminance, which stays; `grey` is the share of colour that is lost, below 1.
void fade(Light* red, Light* green, Light* blue, std::size_t width, double grey);

// Contrasts in bands of an octave, and pictures without those that are too faint to be seen (after Peli 1990).

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
