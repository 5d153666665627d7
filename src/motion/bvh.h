// BVH files: a skeleton of joints with offsets and channels, and which joint moves which body of an infant.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace cli {

// BVH files: a skeleton of joints with offsets, and their channels frame after frame.

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

// Which joint of a skeleton moves which body of an infant, by the names that are usual.

// Joints by bodies ("left_upper_arm", without the infant's own name), for the names of Mixamo, MotionBuilder,
// Biovision, CMU, Poser, Biped, SMPL, Rokoko, LAFAN1 and Unreal.
std::map<std::string, std::size_t> usual_bodies(const std::vector<BvhJoint>& joints);

// Throws a Failure that begins with `source` where a body that an infant's posture needs has no joint, or hangs on none
// of the joints that it should: names that are taken for others would move the wrong limbs.
void check_whole(const std::map<std::string, std::size_t>& bodies, const std::vector<BvhJoint>& joints,
                 const std::string& source);

}  // namespace cli
