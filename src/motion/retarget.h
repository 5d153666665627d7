// A skeleton's movement as one of an infant: who moves what, and how the two stand to each other.
#pragma once

#include <mimo/mimo.hpp>
#include <string>

#include "motion/movement.h"

namespace cli {

struct RetargetOptions {
  std::string map;      // a file of `joint,body` lines, "" for names that are usual
  double scale = 0;     // m for a unit of the file; 0: by the length of the legs
  std::string up;       // the file's axis, "y" or "z"; "": the one along which the head is above the hips
  int rest_frame = -1;  // the frame in which the skeleton stands; -1: as the file's offsets have it
};

// Poses of the first infant's bodies. Both stand upright when nothing turns, soles flat; limbs point where the file's
// do. Changes positions of the world. Throws a Failure that names the file.
Movement read_skeleton(const std::string& path, const RetargetOptions& options, mimo::Env& env);

}  // namespace cli
