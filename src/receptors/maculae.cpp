#include "receptors/maculae.h"

#include <algorithm>
#include <cmath>

#include "receptors/vectors.h"

namespace mimo::receptors {
namespace {

constexpr double kGravity = 9.80665;                             // m/s^2 of one g
constexpr double kCorners[Maculae::kPoles] = {0.1, 1, 10, 100};  // rad/s

// Spikes/s per g: static, and of each high-pass.
struct Gains {
  double still;
  double moving[Maculae::kPoles];
};
constexpr Gains kRegular = {46.165, {8.394, 8.539, 9.786, 14.278}};
constexpr Gains kIrregular = {30.558, {35.685, 68.376, 131.808, 377.814}};

}  // namespace

// Between ticks the force goes in a straight line: then the filters are exact, however fast their corners are.
Maculae::Maculae(bool left, double tick) : first_(left ? 0 : kMaculae * kDirections) {
  for (std::size_t i = 0; i < kPoles; ++i) {
    kept_[i] = std::exp(-kCorners[i] * tick);
    taken_[i] = (1 - kept_[i]) / (kCorners[i] * tick);
    passed_[i].setZero();
  }
}

void Maculae::rest(const Eigen::Vector3d& force) {
  force_ = force / kGravity;
  for (Eigen::Vector3d& passed : passed_) passed.setZero();
}

void Maculae::advance(const Eigen::Vector3d& force) {
  const Eigen::Vector3d now = force / kGravity, change = now - force_;
  for (std::size_t i = 0; i < kPoles; ++i) passed_[i] = kept_[i] * passed_[i] + taken_[i] * change;
  force_ = now;
}

double Maculae::rate(std::size_t macula, std::size_t direction, Afferent type) const {
  const Gains& gains = type == Afferent::kRegular ? kRegular : kIrregular;
  Eigen::Vector3d drive = gains.still * force_;
  for (std::size_t i = 0; i < kPoles; ++i) drive += gains.moving[i] * passed_[i];
  const double along = polarisation(first_ + macula * kDirections + direction).dot(drive);
  return std::max(0.0, kRestingRateOfMacula + along);
}

void Maculae::save(ByteWriter& to) const {
  put(to, force_);
  for (const Eigen::Vector3d& passed : passed_) put(to, passed);
}

void Maculae::load(ByteReader& from) {
  force_ = take(from, "a macula");
  for (Eigen::Vector3d& passed : passed_) passed = take(from, "a macula");
}

}  // namespace mimo::receptors
