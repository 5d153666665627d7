// How well eyes see at an age.
#pragma once

namespace mimo::growth {

struct Eyesight {
  double acuity;         // the finest lines that are seen, cycles per degree
  double peak_contrast;  // greatest contrast sensitivity
  double chroma;         // share of colour that is seen, 0 to 1
  double flicker;        // Hz: where a low-pass in time leaves half the power of a change
};

// At an age in months, 0 to 24.
Eyesight eyesight_at(double age);

}  // namespace mimo::growth
