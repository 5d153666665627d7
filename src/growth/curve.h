// A smooth curve through given points.
#pragma once

#include <vector>

namespace mimo::growth {

// The monotone cubic of Fritsch and Butland (1984): rises where the points rise, goes exactly through each of them and
// has a steady slope. Left and right of the points it keeps their values.
class Curve {
 public:
  // At least three points; x rises.
  Curve(std::vector<double> x, std::vector<double> y);
  double operator()(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace mimo::growth
