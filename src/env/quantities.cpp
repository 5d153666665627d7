#include "env/quantities.h"

#include <array>

#include "base/fail.h"
#include "engine/joints.h"

namespace mimo::env {

const Traits& traits(Quantity quantity) {
  constexpr bool kRead = false, kWrite = true;
  constexpr Moment kAlways = Moment::kAlways, kPose = Moment::kPose, kStep = Moment::kStep;
  static constexpr std::array<Traits, kQuantities> kTraits = {{
      {"joint position", Kind::kJoint, 0, kWrite, kAlways},
      {"joint velocity", Kind::kJoint, 0, kWrite, kAlways},
      {"joint force", Kind::kJoint, 0, kWrite, kAlways},
      {"joint acceleration", Kind::kJoint, 0, kRead, kStep},
      {"joint range", Kind::kJoint, 2, kRead, kAlways},
      {"body position", Kind::kBody, 3, kWrite, kPose},
      {"body orientation", Kind::kBody, 4, kWrite, kPose},
      {"body velocity", Kind::kBody, 6, kRead, kPose},
      {"body force", Kind::kBody, 6, kWrite, kAlways},
      {"body mass", Kind::kBody, 1, kWrite, kAlways},
      {"body center of mass", Kind::kBody, 3, kRead, kPose},
      {"geom position", Kind::kGeom, 3, kRead, kPose},
      {"geom orientation", Kind::kGeom, 4, kRead, kPose},
      {"geom size", Kind::kGeom, 3, kWrite, kAlways},
      {"site position", Kind::kSite, 3, kRead, kPose},
      {"site orientation", Kind::kSite, 4, kRead, kPose},
      {"camera position", Kind::kCamera, 3, kRead, kPose},
      {"camera orientation", Kind::kCamera, 4, kRead, kPose},
      {"actuator control", Kind::kActuator, 1, kWrite, kAlways},
      {"actuator force", Kind::kActuator, 1, kRead, kStep},
      {"sensor value", Kind::kSensor, 0, kRead, kStep},
      {"actuator gear", Kind::kActuator, 1, kWrite, kAlways},
      {"body pose", Kind::kBody, 7, kWrite, kPose},
      {"geom pose", Kind::kGeom, 7, kRead, kPose},
      {"site pose", Kind::kSite, 7, kRead, kPose},
      {"camera pose", Kind::kCamera, 7, kRead, kPose},
      {"geom friction", Kind::kGeom, 3, kWrite, kAlways},
      {"geom color", Kind::kGeom, 4, kWrite, kAlways},
      {"joint damping", Kind::kJoint, 1, kWrite, kAlways},
      {"joint lock", Kind::kJoint, 2, kWrite, kAlways},
      {"light position", Kind::kLight, 3, kWrite, kAlways},
      {"light direction", Kind::kLight, 3, kWrite, kAlways},
      {"light color", Kind::kLight, 3, kWrite, kAlways},
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
      {"agent face", Kind::kAgent, 1, kWrite, kAlways},
      {"world gravity", Kind::kWorld, 3, kWrite, kAlways},
      {"warning count", Kind::kWarning, 1, kWrite, kAlways},
  }};
  return kTraits[static_cast<std::size_t>(quantity) - 1];
}

int width(const mjModel& model, Quantity quantity, int id) {
  if (quantity == Quantity::kJointPosition) return engine::position_count(model.jnt_type[id]);
  if (quantity == Quantity::kSensorValue) return model.sensor_dim[id];
  const int fixed = traits(quantity).width;
  return fixed > 0 ? fixed : engine::velocity_count(model.jnt_type[id]);
}

bool is_alike(Kind kind) { return kind != Kind::kContact && kind != Kind::kStepContact; }

std::size_t width(const World& world, Quantity quantity, const Ids& ids) {
  const Kind kind = traits(quantity).kind;
  const int limit = count(world, kind);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    require(ids[i] >= 0 && ids[i] < limit, "ids[{}] is {}, expected a {} id from 0 to {}", i, ids[i], word(kind),
            limit - 1);
    sum += static_cast<std::size_t>(width(world.model(), quantity, ids[i]));
  }
  return sum;
}

}  // namespace mimo::env
