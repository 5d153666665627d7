// What an infant hears at an age.
#pragma once

namespace mimo::growth {

// The weakest tone that infants of an age in months (0 to 24) turn to or show otherwise that they hear: dB of 20 uPa at
// a frequency in hertz, 125 to 8000 and flat beyond.
double hearing_threshold(double age, double frequency);

}  // namespace mimo::growth
