#include "scene/groups.h"

#include <array>
#include <sstream>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"

namespace mimo::scene {
namespace {

struct Named {
  const char* name;
  unsigned group;
};

constexpr std::array<Named, 11> kGroups = {{{"trunk", kTrunk},
                                            {"head", kHead},
                                            {"eyes", kEyes},
                                            {"right_arm", kRightArm},
                                            {"left_arm", kLeftArm},
                                            {"right_hand", kRightHand},
                                            {"left_hand", kLeftHand},
                                            {"right_leg", kRightLeg},
                                            {"left_leg", kLeftLeg},
                                            {"right_foot", kRightFoot},
                                            {"left_foot", kLeftFoot}}};

// How the names of motors begin, without "act:". The first that fits counts; a hip with a side is a leg's.
constexpr std::array<Named, 18> kMotors = {{{"hip_", kTrunk},
                                            {"head_", kHead},
                                            {"right_eye_", kEyes},
                                            {"left_eye_", kEyes},
                                            {"right_shoulder_", kRightArm},
                                            {"right_elbow", kRightArm},
                                            {"left_shoulder_", kLeftArm},
                                            {"left_elbow", kLeftArm},
                                            {"right_hip_", kRightLeg},
                                            {"right_knee", kRightLeg},
                                            {"left_hip_", kLeftLeg},
                                            {"left_knee", kLeftLeg},
                                            {"right_foot_", kRightFoot},
                                            {"left_foot_", kLeftFoot},
                                            {"right_toes", kRightFoot},
                                            {"left_toes", kLeftFoot},
                                            {"right_big_toe", kRightFoot},
                                            {"left_big_toe", kLeftFoot}}};

}  // namespace

unsigned group_of(const std::string& motor) {
  if (!begins_with(motor, names::kMotor)) return 0;
  const std::string name = motor.substr(std::string(names::kMotor).size());
  for (const Named& entry : kMotors) {
    if (begins_with(name, entry.name)) return entry.group;
  }
  // What is left are wrists and fingers, of which a hand may have many.
  if (begins_with(name, "right_")) return kRightHand;
  return begins_with(name, "left_") ? static_cast<unsigned>(kLeftHand) : 0u;
}

unsigned group_named(const std::string& word) {
  for (const Named& entry : kGroups) {
    if (word == entry.name) return entry.group;
  }
  return 0;
}

unsigned groups_from(const std::string& words) {
  std::istringstream stream(words);
  unsigned groups = 0;
  for (std::string word; stream >> word;) {
    const unsigned group = group_named(word);
    if (group == 0) fail(Status::kModel, "{}: \"{}\" is no part of the infant", names::kActs, word);
    groups |= group;
  }
  return groups;
}

}  // namespace mimo::scene
