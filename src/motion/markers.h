// Markers and key points in space, as motion capture writes them: TRC, Qualisys' TSV and C3D files.
#pragma once

#include <Eigen/Core>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "motion/movement.h"
#include "motion/retarget.h"

namespace cli {

struct Markers {
  std::vector<std::string> names;
  std::vector<double> times;                       // s
  std::vector<std::vector<Eigen::Vector3d>> rows;  // of each time, m; NaN where a marker was not seen
  std::vector<std::string> notes;                  // where the file contradicts itself and is read all the same
};

const Eigen::Vector3d kUnseen = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

// Each throws a Failure that names file, line or frame, and what was expected.
Markers read_trc(const std::string& path);
Markers read_qualisys(const std::string& path);  // of markers, or global poses of a skeleton's segments
Markers read_c3d(const std::string& path);

// Metres of "mm", "cm" or "m"; 0 for another word.
double metres_of(std::string unit);

bool is_marker_file(const std::string& path);  // by its ending

// Points of the first infant's bodies. A gap of up to half a second is bridged by a straight line; longer ones have no
// weight. Turns the world's infant so that the fit begins near the first row.
Movement read_marker_movement(const std::string& path, const RetargetOptions& options, mimo::Env& env);

}  // namespace cli
