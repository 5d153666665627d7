#include "receptors/canals.h"

#include <algorithm>
#include <cmath>

#include "receptors/vectors.h"

namespace mimo::receptors {
namespace {

constexpr double kLong = 5.7;                   // s
constexpr double kDegrees = 57.29577951308232;  // of a radian

// Gain K T2 / T1 in spikes/s per deg/s, and T1, s.
struct Dynamics {
  double gain, lead;
};
constexpr Dynamics kRegular = {2.83 * 0.0027 / 0.0175, 0.0175};
constexpr Dynamics kIrregular = {27.09 * 0.0006 / 0.030, 0.030};

}  // namespace

Canals::Canals(double tick) : tick_(tick), kept_(std::exp(-tick / kLong)) {}

void Canals::rest(const Eigen::Vector3d& angular_velocity) {
  passed_.setZero();
  gained_.setZero();
  before_ = angular_velocity;
}

void Canals::advance(const Eigen::Vector3d& angular_velocity) {
  const Eigen::Vector3d change = angular_velocity - before_;
  passed_ = kept_ * passed_ + change;
  gained_ = change / tick_;
  before_ = angular_velocity;
}

double Canals::rate(std::size_t canal, Afferent type) const {
  const Dynamics& of = type == Afferent::kRegular ? kRegular : kIrregular;
  const double drive = canal_axis(canal).dot(passed_ + of.lead * gained_) * kDegrees;
  return std::max(0.0, resting_rate_of_canal(type) + of.gain * drive);
}

void Canals::save(ByteWriter& to) const {
  for (const Eigen::Vector3d* vector : {&passed_, &before_, &gained_}) put(to, *vector);
}

void Canals::load(ByteReader& from) {
  for (Eigen::Vector3d* vector : {&passed_, &before_, &gained_}) *vector = take(from, "a canal");
}

}  // namespace mimo::receptors
