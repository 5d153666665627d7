#include "env/quantities.h"

#include <array>

#include "base/fail.h"
#include "engine/joints.h"
#include "senses/fusimotor_drives.h"

namespace mimo::env {

const Traits& traits(Quantity quantity) {
  constexpr Writing kRead = Writing::kNever, kWrite = Writing::kState, kKept = Writing::kWorld;
  constexpr Moment kAlways = Moment::kAlways, kPose = Moment::kPose, kStep = Moment::kStep;
  static constexpr std::array<Traits, kQuantities> kTraits = {{
      {"joint position", Kind::kJoint, 0, kWrite, kAlways, "rad", Spatial::kNone, "m"},
      {"joint velocity", Kind::kJoint, 0, kWrite, kAlways, "rad/s", Spatial::kNone, "m/s"},
      {"joint force", Kind::kJoint, 0, kWrite, kAlways, "Nm", Spatial::kNone, "N"},
      {"joint acceleration", Kind::kJoint, 0, kRead, kStep, "rad/s^2", Spatial::kNone, "m/s^2"},
      {"joint range", Kind::kJoint, 2, kRead, kAlways, "rad", Spatial::kNone, "m"},
      {"body position", Kind::kBody, 3, kWrite, kPose, "m", Spatial::kPosition},
      {"body orientation", Kind::kBody, 4, kWrite, kPose, "", Spatial::kOrientation},
      {"body velocity", Kind::kBody, 6, kRead, kPose, "", Spatial::kVelocity},
      {"body force", Kind::kBody, 6, kWrite, kAlways},
      {"body mass", Kind::kBody, 1, kKept, kAlways, "kg"},
      {"body center of mass", Kind::kBody, 3, kRead, kPose, "m", Spatial::kPosition},
      {"geom position", Kind::kGeom, 3, kRead, kPose, "m", Spatial::kPosition},
      {"geom orientation", Kind::kGeom, 4, kRead, kPose, "", Spatial::kOrientation},
      {"geom size", Kind::kGeom, 3, kKept, kAlways, "m"},
      {"site position", Kind::kSite, 3, kRead, kPose, "m", Spatial::kPosition},
      {"site orientation", Kind::kSite, 4, kRead, kPose, "", Spatial::kOrientation},
      {"camera position", Kind::kCamera, 3, kRead, kPose, "m", Spatial::kPosition},
      {"camera orientation", Kind::kCamera, 4, kRead, kPose, "", Spatial::kOrientation},
      {"actuator control", Kind::kActuator, 1, kWrite, kAlways},
      {"actuator force", Kind::kActuator, 1, kRead, kStep},
      {"sensor value", Kind::kSensor, 0, kRead, kStep},
      {"actuator gear", Kind::kActuator, 1, kKept, kAlways},
      {"body pose", Kind::kBody, 7, kWrite, kPose, "", Spatial::kPose},
      {"geom pose", Kind::kGeom, 7, kRead, kPose, "", Spatial::kPose},
      {"site pose", Kind::kSite, 7, kRead, kPose, "", Spatial::kPose},
      {"camera pose", Kind::kCamera, 7, kRead, kPose, "", Spatial::kPose},
      {"geom friction", Kind::kGeom, 3, kKept, kAlways},
      {"geom color", Kind::kGeom, 4, kKept, kAlways},
      {"joint damping", Kind::kJoint, 1, kKept, kAlways, "Nms/rad", Spatial::kNone, "Ns/m"},
      {"joint lock", Kind::kJoint, 2, kKept, kAlways},
      {"light position", Kind::kLight, 3, kKept, kAlways, "m"},
      {"light direction", Kind::kLight, 3, kKept, kAlways},
      {"light color", Kind::kLight, 3, kKept, kAlways},
      {"contact geoms", Kind::kContact, 2, kRead, kStep},
      {"contact bodies", Kind::kContact, 2, kRead, kStep},
      {"contact position", Kind::kContact, 3, kRead, kStep},
      {"contact frame", Kind::kContact, 9, kRead, kStep},
      {"contact distance", Kind::kContact, 1, kRead, kStep},
      {"contact force", Kind::kContact, 3, kRead, kStep},
      {"contact torque", Kind::kContact, 3, kRead, kStep},
      {"step contact geoms", Kind::kStepContact, 2, kRead, kStep},
      {"step contact bodies", Kind::kStepContact, 2, kRead, kStep},
      {"step contact start", Kind::kStepContact, 1, kRead, kStep},
      {"step contact end", Kind::kStepContact, 1, kRead, kStep},
      {"step contact impulse", Kind::kStepContact, 3, kRead, kStep},
      {"step contact peak force", Kind::kStepContact, 3, kRead, kStep},
      {"step contact peak position", Kind::kStepContact, 3, kRead, kStep},
      {"agent face", Kind::kAgent, 1, kKept, kAlways},
      {"world gravity", Kind::kWorld, 3, kKept, kAlways, "m/s^2"},
      {"warning count", Kind::kWarning, 1, kWrite, kAlways},
      {"site velocity", Kind::kSite, 6, kRead, kPose, "", Spatial::kVelocity},
      {"agent goal", Kind::kAgent, 0, kRead, kStep},
      {"agent achieved", Kind::kAgent, 0, kRead, kStep},
      {"agent age", Kind::kAgent, 0, kRead, kAlways, "months"},
      {"agent physiological age", Kind::kAgent, 0, kRead, kAlways, "months"},
      {"body nerve length", Kind::kBody, 1, kRead, kAlways, "m"},
      {"actuator fusimotor drive", Kind::kActuator, 0, kWrite, kAlways, "Hz"},
  }};
  return kTraits[static_cast<std::size_t>(quantity) - 1];
}

namespace {

bool is_age(Quantity quantity) {
  return quantity == Quantity::kAgentAge || quantity == Quantity::kAgentPhysiologicalAge;
}

int width_of_agent(const Agent& agent, Quantity quantity) {
  if (is_age(quantity)) return agent.age ? 1 : 0;
  return agent.task->goal_size();
}

}  // namespace

senses::FusimotorDrives* drives_of(const World& world, int motor) {
  for (const Agent& agent : world.agents()) {
    if (agent.drives && agent.drives->has(motor)) return agent.drives.get();
  }
  return nullptr;
}

int width(const mjModel& model, const World* world, Quantity quantity, int id) {
  const Traits& what = traits(quantity);
  if (what.width > 0) return what.width;
  if (what.kind == Kind::kAgent) return width_of_agent(world->agents()[static_cast<std::size_t>(id)], quantity);
  if (quantity == Quantity::kActuatorFusimotorDrive) {
    return world != nullptr && drives_of(*world, id) != nullptr ? senses::FusimotorDrives::kNumbers : 0;
  }
  if (quantity == Quantity::kSensorValue) return model.sensor_dim[id];
  const int type = model.jnt_type[id];
  return quantity == Quantity::kJointPosition ? engine::position_count(type) : engine::velocity_count(type);
}

bool is_alike(Kind kind) { return kind != Kind::kContact && kind != Kind::kStepContact; }

std::size_t width(const World& world, Quantity quantity, const Ids& ids) {
  const Kind kind = traits(quantity).kind;
  const int limit = count(world, kind);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    require(ids[i] >= 0 && ids[i] < limit, "ids[{}] is {}, expected a {} id from 0 to {}", i, ids[i], word(kind),
            limit - 1);
    sum += static_cast<std::size_t>(width(world.model(), &world, quantity, ids[i]));
  }
  return sum;
}

}  // namespace mimo::env
