// What named access reads and writes.
#pragma once

#include <cstdint>

#include "base/span.h"
#include "env/kinds.h"

namespace mimo::senses {
class FusimotorDrives;
}

namespace mimo::env {

// As mimo.h numbers them (MIMO_JOINT_POSITION ...).
enum class Quantity : int {
  kJointPosition = 1,
  kJointVelocity,
  kJointForce,
  kJointAcceleration,
  kJointRange,
  kBodyPosition,
  kBodyOrientation,
  kBodyVelocity,
  kBodyForce,
  kBodyMass,
  kBodyCenterOfMass,
  kGeomPosition,
  kGeomOrientation,
  kGeomSize,
  kSitePosition,
  kSiteOrientation,
  kCameraPosition,
  kCameraOrientation,
  kActuatorControl,
  kActuatorForce,
  kSensorValue,
  kActuatorGear,
  kBodyPose,
  kGeomPose,
  kSitePose,
  kCameraPose,
  kGeomFriction,
  kGeomColor,
  kJointDamping,
  kJointLock,
  kLightPosition,
  kLightDirection,
  kLightColor,
  kContactGeoms,
  kContactBodies,
  kContactPosition,
  kContactFrame,
  kContactDistance,
  kContactForce,
  kContactTorque,
  kStepContactGeoms,
  kStepContactBodies,
  kStepContactStart,
  kStepContactEnd,
  kStepContactImpulse,
  kStepContactPeakForce,
  kStepContactPeakPosition,
  kAgentFace,
  kWorldGravity,
  kWarningCount,
  kSiteVelocity,
  kAgentGoal,
  kAgentAchieved,
  kAgentAge,
  kAgentPhysiologicalAge,
  kBodyNerveLength,
  kActuatorFusimotorDrive,
};
constexpr int kQuantities = 57;
constexpr int kWidest = 9;  // of those with a width of their own

// When a quantity is true.
enum class Moment {
  kAlways,  // it is not computed
  kPose,    // it follows from positions and velocities: as the last physics step had them, or of now
  kStep,    // physics steps compute it
};

// What it is in space, so that it can be seen from another frame than the world's.
enum class Spatial { kNone, kPosition, kOrientation, kPose, kVelocity };

// Whether a quantity can be written, and where to.
enum class Writing {
  kNever,
  kState,  // of the world, which has none when it has failed
  kWorld,  // outlives resets
};

struct Traits {
  const char* name;
  Kind kind;
  int width;  // 0: depends on the element
  Writing writing;
  Moment moment;
  const char* unit = "";  // of all values; "" where they differ
  Spatial spatial = Spatial::kNone;
  const char* slide_unit = "";  // of joints that slide; `unit` is that of hinges
};
const Traits& traits(Quantity quantity);

// How many values one element has; the world is null where there is only a model, which has no agents.
int width(const mjModel& model, const World* world, Quantity quantity, int id);

// Whose spindles a motor has; null: nobody's.
senses::FusimotorDrives* drives_of(const World& world, int motor);

// Whether other worlds of the same model have as many elements.
bool is_alike(Kind kind);

// Elements of a quantity's kind: some, by their ids, or the first so many, which are all.
class Ids {
 public:
  explicit Ids(Span<const std::int32_t> some) : some_(some), size_(some.size()) {}
  explicit Ids(int all) : size_(static_cast<std::size_t>(all)) {}

  std::size_t size() const { return size_; }
  int operator[](std::size_t i) const { return some_.data() != nullptr ? some_.data()[i] : static_cast<int>(i); }

 private:
  Span<const std::int32_t> some_;
  std::size_t size_;
};

// How many values a quantity has for all ids together. Throws for ids out of range.
std::size_t width(const World& world, Quantity quantity, const Ids& ids);

}  // namespace mimo::env
