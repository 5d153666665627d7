// Which part of the infant a bone belongs to: what shares one set of factors.
#pragma once

#include <string_view>

namespace mimo::growth {

enum class Segment { kTrunk, kHead, kUpperArm, kForearm, kHand, kThigh, kShank, kFoot };

// Throws Status::kUnsupported for a body that is none of ours.
Segment segment_of(std::string_view bone);

// Of arms and legs, but for hands and feet: bones that are as long as a capsule without its round ends.
bool is_limb(Segment segment);

}  // namespace mimo::growth
