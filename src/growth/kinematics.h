// Where the parts of a body are in a pose.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "growth/skeleton.h"

namespace mimo::growth {

using Angles = std::map<std::string, double>;  // rad, by the joints' names; joints that are not named are at 0

// Poses of all bones, in the frame that the first one stands in. Throws Status::kInvalidArgument for an angle of a
// joint that is not there.
std::vector<Eigen::Isometry3d> poses(const Skeleton& skeleton, const Angles& angles);

// Of a geom in the frame of its bone.
Eigen::Isometry3d pose_of(const Geom& geom);

// Height of the lowest and the highest point of all geoms, in the frame that the first bone stands in, m.
double lowest_point(const Skeleton& skeleton, const Angles& angles);
double highest_point(const Skeleton& skeleton, const Angles& angles);

// From the soles to the top of the head, standing straight: where all joints are at 0. In m.
double stature(Skeleton skeleton);

}  // namespace mimo::growth
