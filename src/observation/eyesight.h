// Pictures as an infant's eye passes them on: blurred, pale, without faint contrasts, sluggish.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "observation/blur.h"
#include "observation/contrast.h"

namespace mimo::observation {

struct Eyesight {
  double acuity = 0;         // cycles per degree: the finest grating that it tells from grey; 0: perfect
  double peak_contrast = 2;  // greatest contrast sensitivity, above 1
  double chroma = 1;         // share of colour that is left, 0 to 1
  double flicker = 0;        // Hz: cut-off of a low-pass in time; 0: none
  bool threshold = false;    // contrasts that it cannot see are gone; only where there is an acuity
  double blur = 0;           // cycles per degree of which something before the eye leaves half; 0: nothing is there

  bool any() const { return acuity > 0 || chroma < 1 || flicker > 0 || blur > 0; }
  // Standard deviation, in degrees, of the Gaussian that leaves a grating of full contrast at the acuity just the
  // contrast that is seen there, 1 / peak_contrast.
  double sigma() const;
};

// One over the contrast of a grating that is just seen; below 1 none is.
double sensitivity(const Eyesight& eyes, double cycles_per_degree);

class EyeFilter {
 public:
  // `pixels_per_degree` in the picture's middle; the whole picture is blurred by as many pixels.
  EyeFilter(std::size_t height, std::size_t width, double pixels_per_degree, const Eyesight& eyes);

  // Changes height x width x 3 bytes in place.
  void filter(std::uint8_t* rgb);
  // The same, but nothing of it is remembered.
  void glance(std::uint8_t* rgb);

  std::size_t colours() const { return planes_; }
  // Whether what it shows depends on the pictures before.
  bool remembers() const { return eyes_.flicker > 0; }
  // There was no picture before the next one.
  void begin() { begun_ = false; }
  // Seconds from the picture before to the next one; they hold until told otherwise.
  void advance(double seconds);

  // What it remembers; for another filter of the same sizes and eyesight. `load` throws Status::kInvalidArgument where
  // that cannot be.
  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  void read(const std::uint8_t* rgb, Light* row) const;
  void take(std::size_t y, const Light* row, std::uint8_t* rgb);
  void clear_unseen();
  void write(std::size_t y, const Light* row, std::uint8_t* rgb);
  const Light* remember(std::size_t y, const Light* row);

  std::size_t height_, width_, planes_;  // one plane without colour
  Eyesight eyes_;
  Smoother smoother_;
  Bands bands_;
  std::vector<Light> picture_;    // a whole one, where there are bands
  std::vector<float> luminance_;  // of it, 0 for black
  bool begun_ = false;            // there was a picture before
  bool glances_ = false;
  float share_ = 1;            // of a new picture in what is seen
  std::vector<float> memory_;  // light that is seen
  std::vector<Light> row_;     // a row of it
};

}  // namespace mimo::observation
