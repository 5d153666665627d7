#include "access/body_frame.h"

#include "base/turns.h"
#include "engine/physics.h"

namespace mimo::access {
namespace {

using Vector = Eigen::Map<Eigen::Vector3d>;

Eigen::Quaterniond quaternion(const double* wxyz) { return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]}; }

}  // namespace

BodyFrame::BodyFrame(const mjModel& model, const mjData& data, int body)
    : position_(data.xpos + 3 * body), from_world_(quaternion(data.xquat + 4 * body).conjugate()) {
  std::array<double, 6> moving = engine::body_velocity(model, data, body);
  velocity_ = Vector(moving.data());
  spin_ = Vector(moving.data() + 3);
}

void BodyFrame::see(Spatial what, const Eigen::Vector3d& at, double* values) const {
  switch (what) {
    case Spatial::kNone: break;
    case Spatial::kPosition: see_position(values); break;
    case Spatial::kOrientation: see_orientation(values); break;
    case Spatial::kPose:
      see_position(values);
      see_orientation(values + 3);
      break;
    case Spatial::kVelocity: see_velocity(at, values); break;
  }
}

void BodyFrame::see_position(double* values) const {
  Vector point(values);
  point = from_world_ * (point - position_);
}

void BodyFrame::see_orientation(double* values) const {
  const Eigen::Quaterniond seen = turn_after(from_world_, quaternion(values));
  values[0] = seen.w();
  Vector{values + 1} = seen.vec();
}

// A point of the frame itself moves as well where the frame turns.
void BodyFrame::see_velocity(const Eigen::Vector3d& at, double* values) const {
  Vector linear(values), angular(values + 3);
  linear = from_world_ * (linear - velocity_ - spin_.cross(at - position_));
  angular = from_world_ * (angular - spin_);
}

Eigen::Vector3d place_of(const mjData& data, mimo_kind kind, int id) {
  return Eigen::Vector3d((kind == MIMO_SITE ? data.site_xpos : data.xpos) + 3 * id);
}

}  // namespace mimo::access
