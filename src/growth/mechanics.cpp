#include "growth/mechanics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "base/turns.h"

namespace mimo::growth {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Vector3d point(const Vector& vector) { return {vector[0], vector[1], vector[2]}; }

Isometry3d pose(const Vector& position, const std::array<double, 4>& q) {
  return Eigen::Translation3d(point(position)) * normal_turn(Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
}

Isometry3d turned(const Joint& joint, double angle) {
  const Eigen::Translation3d anchor(point(joint.position));
  return anchor * turn_about<Eigen::Quaterniond>(point(joint.axis).normalized(), angle) * anchor.inverse();
}

void check_names(const Skeleton& skeleton, const Angles& angles) {
  std::size_t found = 0;
  for (const Bone& bone : skeleton.bones) {
    for (const Joint& joint : bone.joints) found += angles.count(joint.name);
  }
  require(found == angles.size(), "the infant has the joints of only {} of {} angles, expected all", found,
          angles.size());
}

// The highest of all points, where up is 1; minus the lowest, where it is -1.
double farthest(const Skeleton& skeleton, const Angles& angles, double up) {
  const std::vector<Isometry3d> bones = poses(skeleton, angles);
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bones.size(); ++i) {
    for (const Geom& geom : skeleton.bones[i].geoms) {
      const Isometry3d at = bones[i] * pose_of(geom);
      const Vector3d vertical = at.linear().transpose() * Vector3d::UnitZ();
      farthest = std::max(farthest, up * at.translation().z() + half_extent(geom, vertical));
    }
  }
  return farthest;
}

using Eigen::Vector3d;

double ball_volume(double radius) { return 4.0 / 3 * kPi * radius * radius * radius; }

double tube_volume(double radius, double half) { return kPi * radius * radius * 2 * half; }

Vector3d tube_inertia(double mass, double radius, double half) {
  const double across = mass * (radius * radius / 4 + half * half / 3);
  return {across, across, mass * radius * radius / 2};
}

// A tube between two halves of a ball. A half's centre of mass is 3/8 of the radius from its flat side.
Vector3d capsule_inertia(double mass, double radius, double half) {
  const double tube = tube_volume(radius, half), ball = ball_volume(radius);
  const double ends = mass * ball / (tube + ball);
  const double round = 0.4 * ends * radius * radius;
  const double across = round + ends * half * (half + 0.75 * radius);
  return tube_inertia(mass - ends, radius, half) + Vector3d(across, across, round);
}

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

}  // namespace

std::vector<Isometry3d> poses(const Skeleton& skeleton, const Angles& angles) {
  check_names(skeleton, angles);
  std::vector<Isometry3d> poses;
  for (const Bone& bone : skeleton.bones) {
    Isometry3d at = pose(bone.position, bone.orientation);
    if (bone.parent >= 0) at = poses[bone.parent] * at;
    for (const Joint& joint : bone.joints) {
      const auto angle = angles.find(joint.name);
      if (angle != angles.end()) at = at * turned(joint, angle->second);
    }
    poses.push_back(at);
  }
  return poses;
}

Isometry3d pose_of(const Geom& geom) { return pose(geom.position, geom.orientation); }

double lowest_point(const Skeleton& skeleton, const Angles& angles) { return -farthest(skeleton, angles, -1); }

double highest_point(const Skeleton& skeleton, const Angles& angles) { return farthest(skeleton, angles, 1); }

double stature(Skeleton skeleton) {
  // The root as it stands in the scene has no say in it.
  skeleton.bones.front().position = {0, 0, 0};
  skeleton.bones.front().orientation = {1, 0, 0, 0};
  return highest_point(skeleton, {}) - lowest_point(skeleton, {});
}

double volume(const Geom& geom) {
  const Vector& size = geom.size;
  switch (geom.shape) {
    case GeomShape::kSphere: return ball_volume(size[0]);
    case GeomShape::kCapsule: return tube_volume(size[0], size[1]) + ball_volume(size[0]);
    case GeomShape::kCylinder: return tube_volume(size[0], size[1]);
    case GeomShape::kBox: break;
  }
  return 8 * size[0] * size[1] * size[2];
}

Vector3d inertia(const Geom& geom) {
  const Vector& size = geom.size;
  switch (geom.shape) {
    case GeomShape::kSphere: return Vector3d::Constant(0.4 * geom.mass * size[0] * size[0]);
    case GeomShape::kCapsule: return capsule_inertia(geom.mass, size[0], size[1]);
    case GeomShape::kCylinder: return tube_inertia(geom.mass, size[0], size[1]);
    case GeomShape::kBox: break;
  }
  const double x = size[0] * size[0], y = size[1] * size[1], z = size[2] * size[2];
  return geom.mass / 3 * Vector3d(y + z, x + z, x + y);
}

double half_extent(const Geom& geom, const Vector3d& direction) {
  const Vector& size = geom.size;
  const double along = std::abs(direction.z()), across = length_of(direction.x(), direction.y());
  switch (geom.shape) {
    case GeomShape::kSphere: return size[0];
    case GeomShape::kCapsule: return size[0] + size[1] * along;
    case GeomShape::kCylinder: return size[0] * across + size[1] * along;
    case GeomShape::kBox: break;
  }
  return direction.cwiseAbs().dot(Vector3d(size[0], size[1], size[2]));
}

std::array<int, 3> bone_axes(const Geom& geom) {
  const auto& q = geom.orientation;
  const Eigen::Matrix3d turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  std::array<int, 3> axes{};
  for (int i = 0; i < 3; ++i) turn.col(i).cwiseAbs().maxCoeff(&axes[i]);
  return axes;
}

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
