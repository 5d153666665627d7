// Nociceptors: fast ones (A-delta) tell at once and adapt, slow ones (C) go on. Pressure, heat and cold.
//
// The threshold of pressure is that of children's pain (Nikolajsen 2011: 180 kPa at 4 to 12 years), times 0.8 for
// infants, an estimate; thresholds of heat and cold are those of adult fibres. Slopes are estimates.
#pragma once

#include <algorithm>

namespace mimo::receptors {

// Pa, of infants.
constexpr double kPainfulPressure = 0.8 * 180e3;

// Mean pressure in Pa where something with this radius of curvature (m, of both surfaces together) presses on soft
// tissue: Hertz, with 0.2 MPa.
double contact_pressure(double force, double radius);

// Degrees Celsius beyond which slow ones fire.
constexpr double kPainfulHeat = 43, kPainfulCold = 18;

// `over` is the pressure in units of the threshold, `adapted` 0 where it has just been crossed, 1 after long. Hz.
inline double fast_pressure_rate(double over, double adapted) {
  return 20 * std::max(0.0, over - 1) * (1 - 0.6 * adapted);
}
inline double slow_pressure_rate(double over) { return 5 * std::max(0.0, over - 0.8); }
// Of the skin's temperature in degrees Celsius. Hz.
inline double fast_heat_rate(double temperature) { return 5 * std::max(0.0, temperature - 46); }
inline double slow_heat_rate(double temperature) {  // and of cold
  return 2 * std::max(0.0, temperature - kPainfulHeat) + std::max(0.0, kPainfulCold - temperature);
}

constexpr double kFastMost = 100, kSlowMost = 20;  // Hz
constexpr double kFastAdapts = 1;                  // s

// Speeds of their nerves, m/s: adults', the fast ones' share of what large fibres conduct at.
constexpr double kFastShare = 13.0 / 56, kSlowSpeed = 0.8;

// The force on foot or leg above which an infant withdraws it, N, by its age in months: 11.8 mN three days old, 45.1 mN
// at a year (Kuhne et al. 2012), geometric between and constant after.
double withdrawal_force(double months);

}  // namespace mimo::receptors
