// Which joint of a skeleton moves which body of an infant, by the names that are usual.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "motion/bvh.h"

namespace cli {

// Joints by bodies ("left_upper_arm", without the infant's own name), for the names of Mixamo, MotionBuilder,
// Biovision, CMU, Poser, Biped, SMPL, Rokoko, LAFAN1 and Unreal.
std::map<std::string, std::size_t> usual_bodies(const std::vector<BvhJoint>& joints);

// Throws a Failure that begins with `source` where a body that an infant's posture needs has no joint, or hangs on none
// of the joints that it should: names that are taken for others would move the wrong limbs.
void check_whole(const std::map<std::string, std::size_t>& bodies, const std::vector<BvhJoint>& joints,
                 const std::string& source);

}  // namespace cli
