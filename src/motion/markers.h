// Points of a body that moves: markers of motion capture, and key points of videos.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <mimo/mimo.hpp>
#include <optional>
#include <string>
#include <vector>

#include "motion/movement.h"
#include "motion/retarget.h"

namespace cli {

struct Markers {
  std::string source;  // the file
  std::vector<std::string> names;
  std::vector<double> times;                       // s
  std::vector<std::vector<Eigen::Vector3d>> rows;  // of each time, m, or pixels u, v, and 0; NaN where one was not seen
  std::vector<std::vector<double>> weights;        // as rows; empty: 1 in all
  std::vector<std::string> notes;                  // where the file contradicts itself and is read all the same
  bool in_pixels = false;
  bool has_own_names = false;    // those of points and bodies here, exactly
  std::optional<Camera> camera;  // of the data set, if it is known

  // For points with weights: a row of no points yet, and its next one, which was not seen without a place or a weight.
  void begin_row(double time);
  void add_weighted(const Eigen::Vector3d& place, double weight);
};

const Eigen::Vector3d kUnseen = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

// Each throws a Failure that names file, line or frame, and what was expected.
Markers read_trc(const std::string& path);
Markers read_qualisys(const std::string& path);  // of markers, or global poses of a skeleton's segments
Markers read_c3d(const std::string& path);
Markers read_key_points(const std::string& path);                // a table of NAME:x, :y, :z or NAME:u, :v, with :w
Markers read_deeplabcut(const std::string& path, double rate);   // a table of one animal
Markers read_openpose(const std::string& folder, double rate);   // a file of each frame, with one person at most
Markers read_mini_rgbd(const std::string& folder, double rate);  // a file of each frame: joints_2Ddep or joints_3D

void require_rate(const std::string& path, double rate);  // of frames of files that have no times

bool is_deeplabcut(const std::string& path);
bool is_mini_rgbd(const std::string& folder);
// Whether a table has key points rather than joints and bodies: pixels, weights, or names that are none of a body.
bool has_key_points(const std::string& path);

// {"matrix": 3 rows of 4}, or a pinhole: {"fovy", "width", "height"} or {"fx", "fy", "cx", "cy"}, each with "position",
// "look_at" and "up".
Camera read_camera(const std::string& path);
// Of an infant that lies on the ground, a metre below.
Camera camera_from_above(double fx, double fy, double cx, double cy);

// Metres of "mm", "cm" or "m"; 0 for another word.
double metres_of(std::string unit);

// Whether a file, or a folder, has points: markers or key points.
bool has_points(const std::string& path);

Markers read_points(const std::string& path, const RetargetOptions& options);

// Points of the first infant's bodies. A gap of up to half a second is bridged by a straight line; longer ones have no
// weight.
Movement point_movement(const Markers& markers, const RetargetOptions& options, mimo::Env& env);

}  // namespace cli
