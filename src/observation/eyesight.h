// How an eye sees: what of a picture is left for one that is less than perfect.
#pragma once

#include <cstdint>
#include <vector>

namespace mimo::observation {

struct Eyesight {
  double acuity = 0;         // the finest lines that are seen, cycles per degree; 0: perfect
  double peak_contrast = 2;  // greatest contrast sensitivity: at the acuity limit this part of the contrast is left
  double chroma = 1;         // share of colour that is seen

  bool any() const { return acuity != 0 || chroma != 1; }
  // Of the Gaussian that leaves 1 / peak_contrast of the contrast at the acuity limit, degrees; 0: perfect.
  double sigma() const;
};

class EyeFilter {
 public:
  // A picture of height x width x 3 bytes, blurred by a Gaussian of `sigma` pixels; a share of its colour is left.
  EyeFilter(std::size_t height, std::size_t width, double sigma, double chroma);

  // In light, not in bytes, and in place; beyond its edges a picture goes on as it is there.
  void filter(std::uint8_t* rgb);

 private:
  void decode(const std::uint8_t* rgb, std::size_t y);
  void blur_columns(std::size_t y);
  void blur_row();
  void fade();
  float* row(std::size_t y) { return rows_.data() + y % kept_ * values_; }

  std::size_t height_, values_;  // values of a row
  float chroma_;
  std::vector<float> kernel_;  // from its middle outwards; one number: no blur
  std::size_t reach_, kept_;   // rows to each side; rows that are needed at once
  std::vector<float> rows_;    // the last of them, in light
  std::vector<float> column_;  // a row blurred up and down, with room for its edges
  std::vector<float> out_;
};

}  // namespace mimo::observation
