// The mechanics of a skeleton: where its parts are in a pose, what they weigh and measure, what its joints carry.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "growth/skeleton.h"

namespace mimo::growth {

// Where the parts of a body are in a pose.

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

// Volume and inertia of a geom.

double volume(const Geom& geom);  // m^3

// About its centre, around its own axes, kg m^2.
Eigen::Vector3d inertia(const Geom& geom);

// Half of its extent along a direction of length 1 in the geom's frame, m.
double half_extent(const Geom& geom, const Eigen::Vector3d& direction);

// Which of the bone's axes (0 x, 1 y, 2 z) each of the geom's own points along, or nearly so.
std::array<int, 3> bone_axes(const Geom& geom);

// What a joint carries.

// Of all that hangs on a joint, where all joints are at 0.
struct Load {
  double moment;  // mass times lever, kg m: its distance from the joint, or where it turns about its centre of mass, as
                  // an eye, its radius of gyration
  double inertia;  // about the joint's axis, kg m^2
};

// Of all joints, by their names.
std::map<std::string, Load> loads(const Skeleton& skeleton);

}  // namespace mimo::growth
