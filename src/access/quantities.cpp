#include "access/quantities.h"

#include <array>
#include <iterator>

#include "base/fail.h"
#include "engine/joints.h"
#include "senses/fusimotor_drives.h"

namespace mimo::access {

namespace {

constexpr Writing kRead = Writing::kNever, kWrite = Writing::kState, kKept = Writing::kWorld;
constexpr Moment kAlways = Moment::kAlways, kPose = Moment::kPose, kStep = Moment::kStep;

// In the order of their numbers, without gaps within a kind.
constexpr Traits kTable[] = {
    {Quantity::kBodyPosition, "body position", 3, kWrite, kPose, "m", Spatial::kPosition},
    {Quantity::kBodyOrientation, "body orientation", 4, kWrite, kPose, "", Spatial::kOrientation},
    {Quantity::kBodyVelocity, "body velocity", 6, kRead, kPose, "", Spatial::kVelocity},
    {Quantity::kBodyForce, "body force", 6, kWrite, kAlways},
    {Quantity::kBodyMass, "body mass", 1, kKept, kAlways, "kg"},
    {Quantity::kBodyCenterOfMass, "body center of mass", 3, kRead, kPose, "m", Spatial::kPosition},
    {Quantity::kBodyPose, "body pose", 7, kWrite, kPose, "", Spatial::kPose},
    {Quantity::kBodyNerveLength, "body nerve length", 1, kRead, kAlways, "m"},
    {Quantity::kJointPosition, "joint position", 0, kWrite, kAlways, "rad", Spatial::kNone, "m"},
    {Quantity::kJointVelocity, "joint velocity", 0, kWrite, kAlways, "rad/s", Spatial::kNone, "m/s"},
    {Quantity::kJointForce, "joint force", 0, kWrite, kAlways, "Nm", Spatial::kNone, "N"},
    {Quantity::kJointAcceleration, "joint acceleration", 0, kRead, kStep, "rad/s^2", Spatial::kNone, "m/s^2"},
    {Quantity::kJointRange, "joint range", 2, kRead, kAlways, "rad", Spatial::kNone, "m"},
    {Quantity::kJointDamping, "joint damping", 1, kKept, kAlways, "Nms/rad", Spatial::kNone, "Ns/m"},
    {Quantity::kJointLock, "joint lock", 2, kKept, kAlways},
    {Quantity::kGeomPosition, "geom position", 3, kRead, kPose, "m", Spatial::kPosition},
    {Quantity::kGeomOrientation, "geom orientation", 4, kRead, kPose, "", Spatial::kOrientation},
    {Quantity::kGeomSize, "geom size", 3, kKept, kAlways, "m"},
    {Quantity::kGeomPose, "geom pose", 7, kRead, kPose, "", Spatial::kPose},
    {Quantity::kGeomFriction, "geom friction", 3, kKept, kAlways},
    {Quantity::kGeomColor, "geom color", 4, kKept, kAlways},
    {Quantity::kSitePosition, "site position", 3, kRead, kPose, "m", Spatial::kPosition},
    {Quantity::kSiteOrientation, "site orientation", 4, kRead, kPose, "", Spatial::kOrientation},
    {Quantity::kSitePose, "site pose", 7, kRead, kPose, "", Spatial::kPose},
    {Quantity::kSiteVelocity, "site velocity", 6, kRead, kPose, "", Spatial::kVelocity},
    {Quantity::kCameraPosition, "camera position", 3, kRead, kPose, "m", Spatial::kPosition},
    {Quantity::kCameraOrientation, "camera orientation", 4, kRead, kPose, "", Spatial::kOrientation},
    {Quantity::kCameraPose, "camera pose", 7, kRead, kPose, "", Spatial::kPose},
    {Quantity::kActuatorControl, "actuator control", 1, kWrite, kAlways},
    {Quantity::kActuatorForce, "actuator force", 1, kRead, kStep},
    {Quantity::kActuatorGear, "actuator gear", 1, kKept, kAlways},
    {Quantity::kActuatorFusimotorDrive, "actuator fusimotor drive", 0, kWrite, kAlways, "Hz"},
    {Quantity::kSensorValue, "sensor value", 0, kRead, kStep},
    {Quantity::kLightPosition, "light position", 3, kKept, kAlways, "m"},
    {Quantity::kLightDirection, "light direction", 3, kKept, kAlways},
    {Quantity::kLightColor, "light color", 3, kKept, kAlways},
    {Quantity::kContactGeoms, "contact geoms", 2, kRead, kStep},
    {Quantity::kContactBodies, "contact bodies", 2, kRead, kStep},
    {Quantity::kContactPosition, "contact position", 3, kRead, kStep},
    {Quantity::kContactFrame, "contact frame", 9, kRead, kStep},
    {Quantity::kContactDistance, "contact distance", 1, kRead, kStep},
    {Quantity::kContactForce, "contact force", 3, kRead, kStep},
    {Quantity::kContactTorque, "contact torque", 3, kRead, kStep},
    {Quantity::kStepContactGeoms, "step contact geoms", 2, kRead, kStep},
    {Quantity::kStepContactBodies, "step contact bodies", 2, kRead, kStep},
    {Quantity::kStepContactStart, "step contact start", 1, kRead, kStep},
    {Quantity::kStepContactEnd, "step contact end", 1, kRead, kStep},
    {Quantity::kStepContactImpulse, "step contact impulse", 3, kRead, kStep},
    {Quantity::kStepContactPeakForce, "step contact peak force", 3, kRead, kStep},
    {Quantity::kStepContactPeakPosition, "step contact peak position", 3, kRead, kStep},
    {Quantity::kAgentFace, "agent face", 1, kKept, kAlways},
    {Quantity::kAgentGoal, "agent goal", 0, kRead, kStep},
    {Quantity::kAgentAchieved, "agent achieved", 0, kRead, kStep},
    {Quantity::kAgentAge, "agent age", 0, kRead, kAlways, "months"},
    {Quantity::kAgentPhysiologicalAge, "agent physiological age", 0, kRead, kAlways, "months"},
    {Quantity::kWorldGravity, "world gravity", 3, kKept, kAlways, "m/s^2"},
    {Quantity::kWarningSteps, "warning steps", 1, kWrite, kAlways},
};
constexpr int kRows = std::size(kTable);

// The first row of each kind; that of kind kKinds + 1 is the end.
constexpr std::array<int, kKinds + 2> first_rows() {
  std::array<int, kKinds + 2> firsts{};
  for (int kind = 0; kind < kKinds + 2; ++kind) {
    int& first = firsts[static_cast<std::size_t>(kind)];
    while (first < kRows && static_cast<int>(kTable[first].kind()) < kind) ++first;
  }
  return firsts;
}
constexpr std::array<int, kKinds + 2> kFirstRows = first_rows();

constexpr bool rows_follow_their_numbers() {
  for (int kind = 1; kind <= kKinds; ++kind) {
    const int first = kFirstRows[static_cast<std::size_t>(kind)];
    for (int row = first; row < kFirstRows[static_cast<std::size_t>(kind) + 1]; ++row) {
      if (static_cast<int>(kTable[row].number) != (kind << kKindShift | (row - first + 1))) return false;
    }
  }
  return kFirstRows[kKinds + 1] == kRows;
}
static_assert(rows_follow_their_numbers(), "a row of the quantities is missing, doubled or not in its place");

}  // namespace

const Traits* find_quantity(mimo_quantity number) {
  const int kind = number >> kKindShift, place = number & kPlaceMask;
  if (kind < 1 || kind > kKinds || place == 0) return nullptr;
  const int row = kFirstRows[static_cast<std::size_t>(kind)] + place - 1;
  return row < kFirstRows[static_cast<std::size_t>(kind) + 1] ? &kTable[row] : nullptr;
}

std::string constant(const Traits& quantity) { return constant(quantity.name); }

const Traits& traits(Quantity quantity) { return *find_quantity(static_cast<mimo_quantity>(quantity)); }

namespace {

bool is_age(Quantity quantity) {
  return quantity == Quantity::kAgentAge || quantity == Quantity::kAgentPhysiologicalAge;
}

int width_of_agent(const env::Agent& agent, Quantity quantity) {
  if (is_age(quantity)) return agent.age ? 1 : 0;
  return agent.task->goal_size();
}

}  // namespace

senses::FusimotorDrives* drives_of(const env::World& world, int motor) {
  for (const env::Agent& agent : world.agents()) {
    if (agent.drives && agent.drives->has(motor)) return agent.drives.get();
  }
  return nullptr;
}

int width(const mjModel& model, const env::World* world, Quantity quantity, int id) {
  const Traits& what = traits(quantity);
  if (what.width > 0) return what.width;
  if (what.kind() == Kind::kAgent) return width_of_agent(world->agents()[static_cast<std::size_t>(id)], quantity);
  if (quantity == Quantity::kActuatorFusimotorDrive) {
    return world != nullptr && drives_of(*world, id) != nullptr ? senses::FusimotorDrives::kNumbers : 0;
  }
  if (quantity == Quantity::kSensorValue) return model.sensor_dim[id];
  const int type = model.jnt_type[id];
  return quantity == Quantity::kJointPosition ? engine::position_count(type) : engine::velocity_count(type);
}

bool is_alike(Kind kind) { return kind != Kind::kContact && kind != Kind::kStepContact; }

std::size_t width(const env::World& world, Quantity quantity, const Ids& ids) {
  const Kind kind = traits(quantity).kind();
  const int limit = count(world, kind);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    require(ids[i] >= 0 && ids[i] < limit, "ids[{}] is {}, expected a {} id from 0 to {}", i, ids[i], word(kind),
            limit - 1);
    sum += static_cast<std::size_t>(width(world.model(), &world, quantity, ids[i]));
  }
  return sum;
}

}  // namespace mimo::access
