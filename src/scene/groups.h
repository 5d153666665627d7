// Parts of the infant whose motors are switched on and off together.
#pragma once

#include <string>

#include "mimo/agent.h"

namespace mimo::scene {

// Bits of the header.
enum Group : unsigned {
  kTrunk = MIMO_ACT_TRUNK,
  kHead = MIMO_ACT_HEAD,
  kEyes = MIMO_ACT_EYES,
  kRightArm = MIMO_ACT_RIGHT_ARM,
  kLeftArm = MIMO_ACT_LEFT_ARM,
  kRightHand = MIMO_ACT_RIGHT_HAND,
  kLeftHand = MIMO_ACT_LEFT_HAND,
  kRightLeg = MIMO_ACT_RIGHT_LEG,
  kLeftLeg = MIMO_ACT_LEFT_LEG,
  kRightFoot = MIMO_ACT_RIGHT_FOOT,
  kLeftFoot = MIMO_ACT_LEFT_FOOT,
  kAllGroups = (kLeftFoot << 1) - 1,
  kNoGroup = MIMO_ACT_NONE,  // excludes the others
};

// The group of a motor, "act:left_elbow"; 0 for one that belongs to none.
unsigned group_of(const std::string& motor);

// The group of a word, "right_arm"; 0 for one that is none.
unsigned group_named(const std::string& word);

// The groups of "right_arm right_hand". Throws Status::kModel for a word that is none.
unsigned groups_from(const std::string& words);

}  // namespace mimo::scene
