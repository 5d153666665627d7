// What a file tells of a movement, row after row: positions of joints, and poses of bodies.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <mimo/mimo.hpp>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// Rotations as an axis times its angle, rad.

// The shorter way round; by the sine where angles are small, as the cosine of those tells nothing.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);

constexpr double kLeastRowSeconds = 1e-6;  // from row to row: what moves in less is a slip of the unit

struct JointTrack {
  std::int32_t hinge;  // the joint whose angle that is, -1 where it is none
  std::vector<double> values;
};

// In the world's frame. One of the two may be empty: not told.
struct BodyTrack {
  std::int32_t body;
  std::vector<Eigen::Vector3d> positions;  // where the movement has a camera: pixels u, v, and 0
  std::vector<Eigen::Quaterniond> orientations;
  Eigen::Vector3d pointer = Eigen::Vector3d::Zero();  // not 0: it counts only where this direction of the body points
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();   // of the point in the body's frame whose positions these are
  std::string point;                                  // its name; "" where it is the body itself
  std::vector<double> weights;                        // of the positions, 0 where they are not known; empty: 1 in all
};

// From the world to pixels: matrix * (x, y, z, 1) = s (u, v, 1), where s is the distance in front, m.
using Camera = Eigen::Matrix<double, 3, 4>;

struct Movement {
  std::string source;  // the file
  std::vector<double> times;
  std::map<std::size_t, JointTrack> joints;  // by their place among the positions
  std::vector<BodyTrack> bodies;
  std::vector<std::string> notes;  // what a reader should know of how the file was read
  bool of_another = false;  // who has other joints: joints should stay within their limits where bodies are followed
  bool of_points = false;   // which may lie anywhere: the whole infant is turned before its joints are
  bool robust = false;      // points that are far off count less
  std::optional<Camera> camera;  // which saw the points
};

// A table with a column `time` in s, then any of
//   a hinge's name, with or without "robot:": rad, or degrees
//   NAME:x, y, z, m, and NAME:qw, qx, qy, qz of a joint that moves freely, or of a body
// The first infant's free joint is also called "root". Throws a Failure that names file and column.
Movement read_movement(const std::string& path, bool degrees, const mimo::Env& env);

// Names of all bodies, for messages.
std::string body_names(const mimo::Env& env);

}  // namespace cli
