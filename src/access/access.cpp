// Named access: reading.
#include "access/access.h"

#include <algorithm>
#include <limits>

#include "base/fail.h"
#include "body/nerves.h"
#include "engine/ground.h"
#include "engine/overrides.h"
#include "engine/present.h"
#include "senses/fusimotor_drives.h"

namespace mimo::access {
namespace {

// Where a quantity that MuJoCo stores as plain numbers lies; null for those that are computed.
const double* stored(const mjModel& model, const mjData& data, Quantity quantity, int id) {
  switch (quantity) {
    case Quantity::kJointPosition: return data.qpos + model.jnt_qposadr[id];
    case Quantity::kJointVelocity: return data.qvel + model.jnt_dofadr[id];
    case Quantity::kJointForce: return data.qfrc_applied + model.jnt_dofadr[id];
    case Quantity::kJointAcceleration: return data.qacc + model.jnt_dofadr[id];
    case Quantity::kJointDamping: return model.dof_damping + model.jnt_dofadr[id];
    case Quantity::kBodyPosition: return data.xpos + 3 * id;
    case Quantity::kBodyOrientation: return data.xquat + 4 * id;
    case Quantity::kBodyForce: return data.xfrc_applied + 6 * id;
    case Quantity::kBodyMass: return model.body_mass + id;
    case Quantity::kBodyCenterOfMass: return data.xipos + 3 * id;
    case Quantity::kGeomPosition: return data.geom_xpos + 3 * id;
    case Quantity::kGeomSize: return model.geom_size + 3 * id;
    case Quantity::kGeomFriction: return model.geom_friction + 3 * id;
    case Quantity::kSitePosition: return data.site_xpos + 3 * id;
    case Quantity::kCameraPosition: return data.cam_xpos + 3 * id;
    case Quantity::kActuatorControl: return data.ctrl + id;
    case Quantity::kActuatorForce: return data.actuator_force + id;
    case Quantity::kSensorValue: return data.sensordata + model.sensor_adr[id];
    case Quantity::kActuatorGear: return model.actuator_gear + 6 * id;
    case Quantity::kLightPosition: return model.light_pos + 3 * id;
    case Quantity::kLightDirection: return model.light_dir + 3 * id;
    case Quantity::kContactPosition: return data.contact[id].pos;
    case Quantity::kContactFrame: return data.contact[id].frame;
    case Quantity::kWorldGravity: return model.opt.gravity;
    default: return nullptr;
  }
}

// Writes numbers one after the other.
class Out {
 public:
  explicit Out(double* to) : to_(to) {}
  Out& put(double value) {
    *to_++ = value;
    return *this;
  }
  template <typename T>
  Out& put(const T* values, int count) {
    to_ = std::copy_n(values, count, to_);
    return *this;
  }
  template <typename T>
  Out& put_all(const T& values) {
    return put(values.data(), static_cast<int>(values.size()));
  }

 private:
  double* to_;
};

void range(const mjModel& model, int joint, Out out) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (model.jnt_limited[joint] != 0) {
    out.put(model.jnt_range + 2 * joint, 2);
  } else {
    out.put(-infinity).put(infinity);
  }
}

void lock(const mjModel& model, int joint, Out out) {
  const int lock = engine::find_lock(model, joint);
  const bool held = lock >= 0 && engine::is_held(model, lock);
  out.put(held ? 1 : 0).put(lock < 0 ? 0.0 : engine::lock_angle(model, lock));
}

void pose(const double* position, const double* matrix, int id, Out out) {
  out.put(position + 3 * id, 3).put_all(engine::quaternion(matrix + 9 * id));
}

void of_step_contact(const env::StepContact& contact, Quantity quantity, Out out) {
  switch (quantity) {
    case Quantity::kStepContactGeoms: out.put_all(contact.geoms); break;
    case Quantity::kStepContactBodies: out.put_all(contact.bodies); break;
    case Quantity::kStepContactStart: out.put(contact.start); break;
    case Quantity::kStepContactEnd: out.put(contact.end); break;
    case Quantity::kStepContactImpulse: out.put_all(contact.impulse); break;
    case Quantity::kStepContactPeakForce: out.put_all(contact.peak_force); break;
    default: out.put_all(contact.peak_position); break;
  }
}

// What only worlds have.
void of_world(const env::World& world, const mjData& data, Quantity quantity, int id, double* to) {
  const auto index = static_cast<std::size_t>(id);
  switch (quantity) {
    case Quantity::kAgentFace: *to = world.face(index); break;
    case Quantity::kAgentGoal: world.agents()[index].task->goal(data, to); break;
    case Quantity::kAgentAchieved: world.agents()[index].task->achieved(data, to); break;
    case Quantity::kAgentAge: *to = world.agents()[index].age->body; break;
    case Quantity::kAgentPhysiologicalAge: *to = world.agents()[index].age->physiology; break;
    case Quantity::kActuatorFusimotorDrive:
      if (const auto* drives = drives_of(world, id)) drives->get(id, to);
      break;
    case Quantity::kWarningSteps: *to = static_cast<double>(world.physics().warnings()[index]); break;
    default: of_step_contact(world.step_contacts().all()[index], quantity, Out(to)); break;
  }
}

void compute(const Source& source, Quantity quantity, int id, double* to) {
  const auto& [model, data, world] = source;
  Out out(to);
  const auto met = [&model = model, &data = data, id] { return engine::meeting(model, data, id); };
  switch (quantity) {
    case Quantity::kJointRange: range(model, id, out); break;
    case Quantity::kJointLock: lock(model, id, out); break;
    case Quantity::kBodyNerveLength: *to = body::nerve_length(model, id); break;
    case Quantity::kBodyVelocity: out.put_all(engine::body_velocity(model, data, id)); break;
    case Quantity::kSiteVelocity: out.put_all(engine::site_velocity(model, data, id)); break;
    case Quantity::kBodyPose: out.put(data.xpos + 3 * id, 3).put(data.xquat + 4 * id, 4); break;
    case Quantity::kGeomOrientation: out.put_all(engine::quaternion(data.geom_xmat + 9 * id)); break;
    case Quantity::kGeomPose: pose(data.geom_xpos, data.geom_xmat, id, out); break;
    case Quantity::kGeomColor: out.put(model.geom_rgba + 4 * id, 4); break;
    case Quantity::kSiteOrientation: out.put_all(engine::quaternion(data.site_xmat + 9 * id)); break;
    case Quantity::kSitePose: pose(data.site_xpos, data.site_xmat, id, out); break;
    case Quantity::kCameraOrientation: out.put_all(engine::quaternion(data.cam_xmat + 9 * id)); break;
    case Quantity::kCameraPose: pose(data.cam_xpos, data.cam_xmat, id, out); break;
    case Quantity::kLightColor: out.put(model.light_diffuse + 3 * id, 3); break;
    case Quantity::kContactGeoms: out.put_all(met().geoms); break;
    case Quantity::kContactBodies: out.put_all(met().bodies); break;
    case Quantity::kContactDistance: *to = -engine::overlap_of(model, data, met()); break;
    case Quantity::kContactForce: out.put(engine::contact_force(model, data, id).data(), 3); break;
    case Quantity::kContactTorque: out.put(engine::contact_force(model, data, id).data() + 3, 3); break;
    default: of_world(*world, data, quantity, id, to); break;
  }
}

template <typename T>
void read_all(const Source& source, Quantity quantity, const Ids& ids, Span<T> values) {
  T* to = values.data();
  static_assert(env::kLargestGoal >= kWidest);
  double computed[env::kLargestGoal];
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int count = width(source.model, source.world, quantity, ids[i]);
    const double* from = stored(source.model, source.data, quantity, ids[i]);
    if (from == nullptr) {
      compute(source, quantity, ids[i], computed);
      from = computed;
    }
    to = std::transform(from, from + count, to, [](double value) { return static_cast<T>(value); });
  }
}

template <typename T>
void read_at(const env::World& world, Quantity quantity, const Ids& ids, bool now, Span<T> values) {
  if (now) require_known_now(quantity);
  if (!now || traits(quantity).moment == Moment::kAlways) {
    return read_all({world.model(), world.data(), &world}, quantity, ids, values);
  }
  engine::Present present;
  read_all({world.model(), present.of(world.physics()), &world}, quantity, ids, values);
}

}  // namespace

void read(const Source& source, Quantity quantity, const Ids& ids, Span<double> values) {
  read_all(source, quantity, ids, values);
}

void get(const env::World& world, Quantity quantity, const Ids& ids, bool now, Span<double> values) {
  read_at(world, quantity, ids, now, values);
}

void get(const env::World& world, Quantity quantity, const Ids& ids, bool now, Span<float> values) {
  read_at(world, quantity, ids, now, values);
}

void require_known_now(Quantity quantity) {
  const Traits& what = traits(quantity);
  require(what.moment != Moment::kStep,
          "quantity is {}, which physics steps compute: it has no MIMO_NOW; mimo_env_observe brings all to now",
          constant(what));
}

}  // namespace mimo::access
