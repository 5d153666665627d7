// A smooth curve through points.
#pragma once

#include <vector>

namespace cli {

// Natural cubic spline: value, speed and acceleration have no jumps. Before the first and behind the last point it goes
// on straight.
class Spline {
 public:
  // Times increase.
  Spline(std::vector<double> times, std::vector<double> values);
  double at(double time) const;

 private:
  std::vector<double> times_, values_, bends_;  // second derivatives
};

}  // namespace cli
