// Light behind the levels of a picture: levels are coded for screens (sRGB), but it is light that adds up in an eye.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mimo::observation {

// Light in 16 bits. Below black and above white there is room for what rounding adds on the way.
using Light = std::uint16_t;
constexpr Light kBlack = 512;
constexpr Light kWhite = 32256;

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
  std::uint8_t level(Light light) const { return level_[light >> 2]; }

  std::array<Light, 256> light_;
  std::array<Light, 256> red_, green_, blue_;  // their shares of the luminance
  std::array<std::uint8_t, 65536 / 4> level_;
};

extern const LightTables kLightTables;  // made when the library is loaded: 511 powers

// Takes colours towards their luminance, which stays; `grey` is the share of colour that is lost, below 1.
void fade(Light* red, Light* green, Light* blue, std::size_t width, double grey);

}  // namespace mimo::observation
