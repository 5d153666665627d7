// BVH files: a skeleton of joints with offsets, and their channels frame after frame.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace cli {

struct BvhJoint {
  std::string name;
  int parent;              // -1: a root
  Eigen::Vector3d offset;  // from its parent, in the file's unit
  Eigen::Vector3d end;     // from here to its end site, 0 without one
  std::string channels;    // a letter each: X, Y, Z move, x, y, z turn
  std::size_t first;       // of its channels in a frame
};

struct Bvh {
  std::vector<BvhJoint> joints;  // parents before their children
  double frame_seconds;
  std::vector<std::vector<double>> frames;
  std::vector<std::string> notes;  // where the file contradicts itself and is read all the same

  // Places and orientations of all joints in a frame, or at rest, where no channel turns or moves anything.
  std::vector<Eigen::Isometry3d> poses(std::size_t frame) const;
  std::vector<Eigen::Isometry3d> rest() const;
};

// Throws a Failure that names file and line.
Bvh read_bvh(const std::string& path);

}  // namespace cli
