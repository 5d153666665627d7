// Parts of the infant whose motors are switched on and off together.
#pragma once

#include <string>

namespace mimo::scene {

// Bits, as mimo.h numbers them (MIMO_ACT_...).
enum Group : unsigned {
  kTrunk = 0x01,
  kHead = 0x02,
  kEyes = 0x04,
  kRightArm = 0x08,
  kLeftArm = 0x10,
  kRightHand = 0x20,
  kLeftHand = 0x40,
  kRightLeg = 0x80,
  kLeftLeg = 0x100,
  kRightFoot = 0x200,
  kLeftFoot = 0x400,
  kAllGroups = 0x7ff,
  kNoGroup = 0x40000000,  // excludes the others
};

// The group of a motor, "act:left_elbow"; 0 for one that belongs to none.
unsigned group_of(const std::string& motor);

// The group of a word, "right_arm"; 0 for one that is none.
unsigned group_named(const std::string& word);

// The groups of "right_arm right_hand". Throws Status::kModel for a word that is none.
unsigned groups_from(const std::string& words);

}  // namespace mimo::scene
