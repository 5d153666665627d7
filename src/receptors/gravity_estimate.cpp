#include "receptors/gravity_estimate.h"

#include <Eigen/Geometry>
#include <cmath>

#include "receptors/vectors.h"

namespace mimo::receptors {
namespace {

constexpr double kBelief = 1.5;  // s

}  // namespace

GravityEstimate::GravityEstimate(double tick) : tick_(tick), kept_(std::exp(-tick / kBelief)) {}

// In the head's frame the world turns the other way.
void GravityEstimate::advance(const Eigen::Vector3d& force, const Eigen::Vector3d& turning) {
  const double angle = turning.norm() * tick_;
  if (angle > 0) up_ = Eigen::AngleAxisd(-angle, turning.normalized()) * up_;
  up_ = force + kept_ * (up_ - force);
}

void GravityEstimate::save(ByteWriter& to) const { put(to, up_); }
void GravityEstimate::load(ByteReader& from) { up_ = take(from, "the estimate of gravity"); }

}  // namespace mimo::receptors
