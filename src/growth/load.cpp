#include "growth/load.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "growth/kinematics.h"
#include "growth/solids.h"

namespace mimo::growth {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// A geom as what has weight, in the frame that the first bone stands in.
struct Weight {
  double mass;
  Vector3d centre;
  Matrix3d inertia;  // about its centre
};

using Weights = std::vector<Weight>;

Weight weight_of(const Geom& geom, const Isometry3d& bone) {
  const Isometry3d at = bone * pose_of(geom);
  const Matrix3d turn = at.linear();
  return {geom.mass, at.translation(), turn * inertia(geom).asDiagonal() * turn.transpose()};
}

// For each bone, all that is fixed to it and to what hangs on it.
std::vector<Weights> carried_by(const Skeleton& skeleton, const std::vector<Isometry3d>& poses) {
  std::vector<Weights> carried(poses.size());
  for (std::size_t i = poses.size(); i-- > 0;) {
    const Bone& bone = skeleton.bones[i];
    for (const Geom& geom : bone.geoms) carried[i].push_back(weight_of(geom, poses[i]));
    if (bone.parent < 0) continue;
    Weights& parent = carried[bone.parent];
    parent.insert(parent.end(), carried[i].begin(), carried[i].end());
  }
  return carried;
}

Load load_on(const Vector3d& anchor, const Vector3d& axis, const Weights& weights) {
  constexpr double kCentred = 1e-6;  // m
  double mass = 0, inertia = 0;
  Vector3d moment = Vector3d::Zero();
  for (const Weight& weight : weights) {
    const Vector3d lever = weight.centre - anchor;
    mass += weight.mass;
    moment += weight.mass * lever;
    inertia += axis.dot(weight.inertia * axis) + weight.mass * lever.cross(axis).squaredNorm();
  }
  const bool centred = moment.norm() <= kCentred * mass;
  return {centred ? std::sqrt(mass * inertia) : moment.norm(), inertia};
}

Vector3d point(const Vector& vector) { return {vector[0], vector[1], vector[2]}; }

}  // namespace

std::map<std::string, Load> loads(const Skeleton& skeleton) {
  const std::vector<Isometry3d> at = poses(skeleton, {});
  const std::vector<Weights> carried = carried_by(skeleton, at);
  std::map<std::string, Load> loads;
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const Joint& joint : skeleton.bones[i].joints) {
      const Vector3d axis = at[i].linear() * point(joint.axis).normalized();
      loads[joint.name] = load_on(at[i] * point(joint.position), axis, carried[i]);
    }
  }
  return loads;
}

}  // namespace mimo::growth
