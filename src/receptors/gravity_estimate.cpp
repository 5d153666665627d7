#include "receptors/gravity_estimate.h"

#include <Eigen/Geometry>
#include <cmath>

#include "receptors/canals.h"
#include "receptors/vectors.h"

namespace mimo::receptors {
namespace {

// Laurens et al. 2013, fitted to monkeys. They store 0.247 a second of what canals of 4 s tell, nearly all that these
// forget; the same share of what ours forget.
constexpr double kBelief = 1 / 0.65;                   // s
constexpr double kStored = 0.247 * 4 / kCanalsForget;  // 1/s
constexpr double kLeak = 14;                           // s
constexpr double kCorrection = 0.38;                   // rad/s^2, where force and belief are at right angles

}  // namespace

GravityEstimate::GravityEstimate(double tick) : tick_(tick), kept_(std::exp(-tick / kBelief)) {}

void GravityEstimate::rest(const Eigen::Vector3d& force) {
  up_ = force;
  stored_.setZero();
}

// In the head's frame the world turns the other way.
void GravityEstimate::advance(const Eigen::Vector3d& force, const Eigen::Vector3d& told) {
  const Eigen::Vector3d turning = told + stored_;
  const double angle = turning.norm() * tick_;
  if (angle > 0) up_ = Eigen::AngleAxisd(-angle, turning.normalized()) * up_;
  up_ = force + kept_ * (up_ - force);
  stored_ += tick_ * (kStored * told - stored_ / kLeak);
  const double lengths = force.norm() * up_.norm();
  if (lengths > 0) stored_ += tick_ * kCorrection / lengths * force.cross(up_);
}

void GravityEstimate::save(ByteWriter& to) const {
  put(to, up_);
  put(to, stored_);
}

void GravityEstimate::load(ByteReader& from) {
  up_ = take(from, "the estimate of gravity");
  stored_ = take(from, "the estimate of gravity");
}

}  // namespace mimo::receptors
