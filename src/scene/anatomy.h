// An infant's body in a document: read as numbers and written back, with its joints and groups of motors.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "growth/skeleton.h"
#include "mimo/agent.h"

namespace mimo::scene {

// An infant's body in a document: read as numbers, and numbers written back.

class Anatomy {
 public:
  // Throws Status::kNotFound where the document has no infant of that prefix.
  Anatomy(pugi::xml_node root, const std::string& prefix);

  const growth::Skeleton& skeleton() const { return skeleton_; }
  // The body with everything that hangs on it.

  // Writes what differs from the skeleton, and tells whether anything does. The other one has the same parts in the
  // same order.
  bool write(const growth::Skeleton& changed);

 private:
  struct Reader;

  pugi::xml_node root_;
  growth::Skeleton skeleton_;
  std::vector<pugi::xml_node> bones_, geoms_, joints_, marks_, motors_;  // elements, in the skeleton's order
};

// Parts of the infant whose motors are switched on and off together.

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

// Joints of a document: where they start and where they are held. Values are radians or metres.

// Both throw Status::kNotFound for a joint that is not there, and kInvalidArgument for one that is not a hinge or
// slide, and for a value out of its range.
void start_joint(pugi::xml_node root, const std::string& joint, double value);
// It starts where it is held.
void lock_joint(pugi::xml_node root, const std::string& joint, double value);

}  // namespace mimo::scene
