#include "receptors/canals.h"

#include <algorithm>
#include <cmath>

#include "receptors/vectors.h"

namespace mimo::receptors {
namespace {

constexpr double kLong = 5.7;                   // s
constexpr double kDegrees = 57.29577951308232;  // of a radian

// Gain K T2 / T1 in spikes/s per deg/s, T1 and T2, s.
struct Dynamics {
  double gain, lead, lag;
};
constexpr Dynamics kDynamics[kAfferents] = {{2.83 * 0.0027 / 0.0175, 0.0175, 0.0027},
                                            {27.09 * 0.0006 / 0.030, 0.030, 0.0006}};

}  // namespace

Canals::Canals(double tick) : tick_(tick), kept_(std::exp(-tick / kLong)) {
  for (std::size_t type = 0; type < kAfferents; ++type) {
    kept_drive_[type] = std::exp(-tick / kDynamics[type].lag);
    driven_[type].setZero();
  }
}

void Canals::rest(const Eigen::Vector3d& angular_velocity) {
  passed_.setZero();
  for (Eigen::Vector3d& driven : driven_) driven.setZero();
  before_ = angular_velocity;
}

void Canals::advance(const Eigen::Vector3d& angular_velocity) {
  const Eigen::Vector3d change = angular_velocity - before_;
  passed_ = kept_ * passed_ + change;
  for (std::size_t type = 0; type < kAfferents; ++type) {
    const Eigen::Vector3d drive = passed_ + kDynamics[type].lead / tick_ * change;
    driven_[type] = drive + kept_drive_[type] * (driven_[type] - drive);
  }
  before_ = angular_velocity;
}

double Canals::rate(std::size_t canal, Afferent type) const {
  const auto index = static_cast<std::size_t>(type);
  const double drive = canal_axis(canal).dot(driven_[index]) * kDegrees;
  return std::max(0.0, resting_rate_of_canal(type) + kDynamics[index].gain * drive);
}

void Canals::save(ByteWriter& to) const {
  for (const Eigen::Vector3d& vector : {passed_, before_, driven_[0], driven_[1]}) put(to, vector);
}

void Canals::load(ByteReader& from) {
  for (Eigen::Vector3d* vector : {&passed_, &before_, &driven_[0], &driven_[1]}) *vector = take(from, "a canal");
}

}  // namespace mimo::receptors
