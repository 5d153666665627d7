// A skeleton's movement as one of an infant: by its joints, or by least squares of its bodies' poses.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "motion/movement.h"

namespace cli {

// Positions of joints out of poses of bodies: least squares over all joints between those bodies, row after row.

// How far a body is from where it was told to be, because its joints cannot follow.
struct PoseError {
  std::int32_t body;
  std::string point;                               // of it, "" for its origin
  double angle_largest = 0, angle_mean = 0;        // rad
  double distance_largest = 0, distance_mean = 0;  // m, or pixels where a camera saw the points
  std::vector<double> distances;                   // of each row, NaN where the point was not seen
};

// Adds tracks of all joints that the bodies' poses say something about and that have none yet. Changes positions and
// velocities of the world. A centimetre counts as much as a tenth of a radian and as five pixels.
std::vector<PoseError> fit_poses(Movement& movement, mimo::Env& env);

// What is left of a few rows of points when joints and place of the infant fit best: the sum of squares, in tenths of a
// radian. `poses` are where to begin, and then what was found; empty at first.
double misfit(const Movement& movement, mimo::Env& env, std::vector<std::vector<double>>& poses);

// A skeleton's movement as one of an infant: who moves what, and how the two stand to each other.

struct RetargetOptions {
  std::string map;      // a file of `joint,body` lines, "" for names that are usual
  double scale = 0;     // m for a unit of the file; 0: by the length of the legs
  std::string up;       // the file's axis, "y" or "z"; "": the one along which the head is above the hips
  int rest_frame = -1;  // the frame in which the skeleton stands; -1: as the file's offsets have it
  std::string camera;   // of points in pixels: its file
  double rate = 0;      // frames a second of files without times
  bool robust = false;  // points that are far off count less
};

// Poses of the first infant's bodies. Both stand upright when nothing turns, soles flat; limbs point where the file's
// do. Changes positions of the world. Throws a Failure that names the file.
Movement read_skeleton(const std::string& path, const RetargetOptions& options, mimo::Env& env);

}  // namespace cli
