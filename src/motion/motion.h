// A movement that is known, at any time: smooth curves through what its file tells of the joints.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "motion/movement.h"

namespace cli {

// A smooth curve through points.

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

class Motion {
 public:
  // Joints without a track stay where the world has them. A cutoff, Hz, filters the tracks; 0: none. Throws a Failure
  // where an orientation is not whole, and where rows cannot be filtered.
  Motion(const Movement& movement, const mimo::Env& env, double cutoff = 0);

  double seconds() const { return last_ - first_; }
  std::size_t rows() const { return rows_; }
  // Of all joints, so many seconds after the first row.
  std::vector<double> positions(double seconds) const;
  // Of all degrees of freedom, with which a step of physics ends there.
  std::vector<double> velocities(const mimo::Env& env, double seconds) const;
  // Names of joints that are told to go beyond their limits.
  std::vector<std::string> beyond_limits(const mimo::Env& env) const;

 private:
  struct Track {
    std::size_t place;  // among the positions
    Spline curve;
    double low, high;    // of all rows
    std::int32_t hinge;  // the joint whose angle that is, -1 where it is none
  };

  std::vector<double> still_;             // positions of what is not told
  std::vector<std::size_t> quaternions_;  // places of their first numbers
  std::vector<Track> tracks_;
  double first_, last_;
  std::size_t rows_;
};

}  // namespace cli
