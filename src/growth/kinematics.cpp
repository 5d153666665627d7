#include "growth/kinematics.h"

#include <algorithm>
#include <limits>

#include "base/fail.h"
#include "growth/solids.h"

namespace mimo::growth {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Vector3d point(const Vector& vector) { return {vector[0], vector[1], vector[2]}; }

Isometry3d pose(const Vector& position, const std::array<double, 4>& q) {
  return Eigen::Translation3d(point(position)) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
}

Isometry3d turned(const Joint& joint, double angle) {
  const Eigen::Translation3d anchor(point(joint.position));
  return anchor * Eigen::AngleAxisd(angle, point(joint.axis).normalized()) * anchor.inverse();
}

void check_names(const Skeleton& skeleton, const Angles& angles) {
  std::size_t found = 0;
  for (const Bone& bone : skeleton.bones) {
    for (const Joint& joint : bone.joints) found += angles.count(joint.name);
  }
  require(found == angles.size(), "{} of {} angles are of joints that the infant has, expected all", found,
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

}  // namespace mimo::growth
