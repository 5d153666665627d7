// What named access reads and writes.
#pragma once

#include <cstdint>

#include "access/kinds.h"
#include "base/span.h"
#include "mimo/experimental.h"

namespace mimo::senses {
class FusimotorDrives;
}

namespace mimo::access {

// Of the header.
enum class Quantity : mimo_quantity {
  kJointPosition = MIMO_JOINT_POSITION,
  kJointVelocity = MIMO_JOINT_VELOCITY,
  kJointForce = MIMO_JOINT_FORCE,
  kJointAcceleration = MIMO_JOINT_ACCELERATION,
  kJointRange = MIMO_JOINT_RANGE,
  kBodyPosition = MIMO_BODY_POSITION,
  kBodyOrientation = MIMO_BODY_ORIENTATION,
  kBodyVelocity = MIMO_BODY_VELOCITY,
  kBodyForce = MIMO_BODY_FORCE,
  kBodyMass = MIMO_BODY_MASS,
  kBodyCenterOfMass = MIMO_BODY_CENTER_OF_MASS,
  kGeomPosition = MIMO_GEOM_POSITION,
  kGeomOrientation = MIMO_GEOM_ORIENTATION,
  kGeomSize = MIMO_GEOM_SIZE,
  kSitePosition = MIMO_SITE_POSITION,
  kSiteOrientation = MIMO_SITE_ORIENTATION,
  kCameraPosition = MIMO_CAMERA_POSITION,
  kCameraOrientation = MIMO_CAMERA_ORIENTATION,
  kActuatorControl = MIMO_ACTUATOR_CONTROL,
  kActuatorForce = MIMO_ACTUATOR_FORCE,
  kSensorValue = MIMO_SENSOR_VALUE,
  kActuatorGear = MIMO_ACTUATOR_GEAR,
  kBodyPose = MIMO_BODY_POSE,
  kGeomPose = MIMO_GEOM_POSE,
  kSitePose = MIMO_SITE_POSE,
  kCameraPose = MIMO_CAMERA_POSE,
  kGeomFriction = MIMO_GEOM_FRICTION,
  kGeomColor = MIMO_GEOM_COLOR,
  kJointDamping = MIMO_JOINT_DAMPING,
  kJointLock = MIMO_JOINT_LOCK,
  kLightPosition = MIMO_LIGHT_POSITION,
  kLightDirection = MIMO_LIGHT_DIRECTION,
  kLightColor = MIMO_LIGHT_COLOR,
  kContactGeoms = MIMO_CONTACT_GEOMS,
  kContactBodies = MIMO_CONTACT_BODIES,
  kContactPosition = MIMO_CONTACT_POSITION,
  kContactFrame = MIMO_CONTACT_FRAME,
  kContactDistance = MIMO_CONTACT_DISTANCE,
  kContactForce = MIMO_CONTACT_FORCE,
  kContactTorque = MIMO_CONTACT_TORQUE,
  kStepContactGeoms = MIMO_STEP_CONTACT_GEOMS,
  kStepContactBodies = MIMO_STEP_CONTACT_BODIES,
  kStepContactStart = MIMO_STEP_CONTACT_START,
  kStepContactEnd = MIMO_STEP_CONTACT_END,
  kStepContactImpulse = MIMO_STEP_CONTACT_IMPULSE,
  kStepContactPeakForce = MIMO_STEP_CONTACT_PEAK_FORCE,
  kStepContactPeakPosition = MIMO_STEP_CONTACT_PEAK_POSITION,
  kAgentFace = MIMO_AGENT_FACE,
  kWorldGravity = MIMO_WORLD_GRAVITY,
  kWarningSteps = MIMO_WARNING_STEPS,
  kSiteVelocity = MIMO_SITE_VELOCITY,
  kAgentGoal = MIMO_AGENT_GOAL,
  kAgentAchieved = MIMO_AGENT_ACHIEVED,
  kAgentAge = MIMO_AGENT_AGE,
  kAgentPhysiologicalAge = MIMO_AGENT_PHYSIOLOGICAL_AGE,
  kBodyNerveLength = MIMO_BODY_NERVE_LENGTH,
  kActuatorFusimotorDrive = MIMO_ACTUATOR_FUSIMOTOR_DRIVE,
};
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

// The number of a quantity is that of its kind, shifted, and a place among the quantities of that kind, from 1.
constexpr int kKindShift = 8;
constexpr int kPlaceMask = (1 << kKindShift) - 1;

struct Traits {
  Quantity number;
  const char* name;
  int width;  // 0: depends on the element
  Writing writing;
  Moment moment;
  const char* unit = "";  // of all values; "" where they differ
  Spatial spatial = Spatial::kNone;
  const char* slide_unit = "";  // of joints that slide; `unit` is that of hinges

  constexpr Kind kind() const { return static_cast<Kind>(static_cast<int>(number) >> kKindShift); }
};
std::string constant(const Traits& quantity);       // "MIMO_JOINT_POSITION"
const Traits* find_quantity(mimo_quantity number);  // null: there is none of that number
const Traits& traits(Quantity quantity);

// How many values one element has; the world is null where there is only a model, which has no agents.
int width(const mjModel& model, const env::World* world, Quantity quantity, int id);

// Whose spindles a motor has; null: nobody's.
senses::FusimotorDrives* drives_of(const env::World& world, int motor);

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
std::size_t width(const env::World& world, Quantity quantity, const Ids& ids);

}  // namespace mimo::access
