// Named access: writing.
#include <algorithm>
#include <cmath>

#include "access/access.h"
#include "base/fail.h"
#include "base/finite.h"
#include "engine/joints.h"
#include "engine/overrides.h"
#include "senses/fusimotor_drives.h"

namespace mimo::access {
namespace {

// The free joint of a body, by which it can be moved; -1 if it has none.
int free_joint(const mjModel& model, int body) {
  const int joint = model.body_jntadr[body];
  return joint >= 0 && model.jnt_type[joint] == mjJNT_FREE ? joint : -1;
}

// Stands on the world and cannot move in it.
bool is_fixed(const mjModel& model, int body) {
  return body > 0 && model.body_parentid[body] == 0 && model.body_jntnum[body] == 0;
}

bool moves_bodies(Quantity quantity) {
  return quantity == Quantity::kJointPosition || quantity == Quantity::kBodyPosition ||
         quantity == Quantity::kBodyOrientation || quantity == Quantity::kBodyPose ||
         quantity == Quantity::kLightPosition || quantity == Quantity::kLightDirection;
}

double norm(const double* numbers, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += numbers[i] * numbers[i];
  return std::sqrt(sum);
}

// Numbers whose squares are too large for a double have a direction too.
void normalise(double* numbers, int count) {
  if (std::isinf(norm(numbers, count))) std::for_each(numbers, numbers + count, [](double& x) { x *= 1e-200; });
  const double length = norm(numbers, count);
  std::for_each(numbers, numbers + count, [length](double& x) { x /= length; });
}

// ---- What is refused ------------------------------------------------------------------------------------------------

// Where the quaternion starts among the values of one element; -1 if there is none.
int quaternion_at(const mjModel& model, Quantity quantity, int id) {
  if (quantity == Quantity::kBodyOrientation) return 0;
  if (quantity == Quantity::kBodyPose) return 3;
  return quantity == Quantity::kJointPosition ? engine::quaternion_place(model.jnt_type[id]) : -1;
}

void check_place(const mjModel& model, int body) {
  require(free_joint(model, body) >= 0 || is_fixed(model, body),
          "body {} (\"{}\") cannot be moved: it has no free joint, and does not stand on the world by itself", body,
          engine::name(model, engine::Kind::kBody, body));
}

// What is there already may be written back.
void check_mass(const mjModel& model, int body, double mass) {
  if (mass == model.body_mass[body]) return;
  const char* name = engine::name(model, engine::Kind::kBody, body);
  require(body > 0 && model.body_mass[body] > 0, "body {} (\"{}\") has no mass that could be changed", body, name);
  require(mass > 0, "values: the mass of body {} (\"{}\") is {}, expected kilograms above 0", body, name, mass);
}

void check_size(const mjModel& model, int geom, const double* size) {
  if (std::equal(size, size + 3, model.geom_size + 3 * geom)) return;
  const int count = engine::size_count(model.geom_type[geom]);
  const char* name = engine::name(model, engine::Kind::kGeom, geom);
  require(count > 0, "geom {} (\"{}\") is a plane, mesh or height field, whose size cannot be changed", geom, name);
  for (int i = 0; i < count; ++i) {
    require(size[i] > 0, "values: size {} of geom {} (\"{}\") is {}, expected metres above 0", i, geom, name, size[i]);
  }
}

void check_between(const char* what, int id, const double* values, int count, double low, double high) {
  for (int i = 0; i < count; ++i) {
    require(values[i] >= low && values[i] <= high, "values: the {} of {} is {}, expected {} to {}", what, id, values[i],
            low, high);
  }
}

void check_not_negative(const char* what, int id, const double* values, int count) {
  for (int i = 0; i < count; ++i) {
    require(values[i] >= 0, "values: the {} of {} is {}, expected 0 or more", what, id, values[i]);
  }
}

void check_lock(const env::World& world, int joint, const double* values) {
  const mjModel& model = world.model();
  const char* name = engine::name(model, engine::Kind::kJoint, joint);
  const int lock = engine::find_lock(model, joint);
  if (lock < 0) fail(Status::kUnsupported, "joint {} (\"{}\") has no equality that could hold it", joint, name);
  for (const env::Agent& agent : world.agents()) {
    if (!agent.actuation->holds(lock)) continue;
    fail(Status::kUnsupported, "joint {} (\"{}\") is under position control: its actions hold it", joint, name);
  }
  require(values[0] == 0 || values[0] == 1, "values: the lock of joint \"{}\" is {}, expected 0 or 1", name, values[0]);
  const double* range = model.jnt_range + 2 * joint;
  const bool within = model.jnt_limited[joint] == 0 || (values[1] >= range[0] && values[1] <= range[1]);
  require(values[0] == 0 || within, "values: the angle is {}, expected {} to {} for joint \"{}\"", values[1], range[0],
          range[1], name);
}

void check_light(const mjModel& model, Quantity quantity, int light, const double* values) {
  const int mode = model.light_mode[light];
  const bool follows = quantity == Quantity::kLightPosition ? mode == mjCAMLIGHT_TRACK || mode == mjCAMLIGHT_TRACKCOM
                                                            : mode != mjCAMLIGHT_FIXED;
  if (follows) {
    fail(Status::kUnsupported, "light {} (\"{}\") follows a body, which says where it is and shines", light,
         engine::name(model, engine::Kind::kLight, light));
  }
  require(quantity == Quantity::kLightPosition || norm(values, 3) > 1e-9, "values: the direction of light {} is zero",
          light);
}

void check_face(const env::World& world, int agent, double face) {
  const env::Agent& whose = world.agents()[static_cast<std::size_t>(agent)];
  if (whose.faces.geom < 0) fail(Status::kUnsupported, "agent {} (\"{}\") has no face", agent, whose.name);
  const auto count = static_cast<double>(world.faces().size());
  require(face >= 0 && face < count && face == std::floor(face), "values: the face is {}, expected 0 to {}", face,
          count - 1);
}

void check_element(const env::World& world, Quantity quantity, int id, const double* values) {
  constexpr double kBrightest = 100;
  const mjModel& model = world.model();
  switch (quantity) {
    case Quantity::kBodyPosition:
    case Quantity::kBodyOrientation:
    case Quantity::kBodyPose: check_place(model, id); break;
    case Quantity::kBodyMass: check_mass(model, id, *values); break;
    case Quantity::kGeomSize: check_size(model, id, values); break;
    case Quantity::kGeomFriction: check_not_negative("friction of geom", id, values, 3); break;
    case Quantity::kGeomColor: check_between("color of geom", id, values, 4, 0, 1); break;
    case Quantity::kJointDamping: check_not_negative("damping of joint", id, values, 1); break;
    case Quantity::kJointLock: check_lock(world, id, values); break;
    case Quantity::kLightPosition:
    case Quantity::kLightDirection: check_light(model, quantity, id, values); break;
    case Quantity::kLightColor: check_between("color of light", id, values, 3, 0, kBrightest); break;
    case Quantity::kActuatorFusimotorDrive:
      check_between("fusimotor drive of actuator", id, values, width(model, &world, quantity, id), 0,
                    receptors::kMostFusimotorDrive);
      break;
    case Quantity::kAgentFace: check_face(world, id, *values); break;
    case Quantity::kWarningSteps: check_between("steps of warning", id, values, 1, 0, 0); break;
    default: break;
  }
  const int quaternion = quaternion_at(model, quantity, id);
  require(quaternion < 0 || norm(values + quaternion, 4) > 1e-9, "values: the quaternion of {} {} is zero",
          word(traits(quantity).kind()), id);
}

// ---- What is written ------------------------------------------------------------------------------------------------

void place(engine::Physics& physics, int body, const double* position, const double* orientation) {
  const int joint = free_joint(physics.model(), body);
  if (joint < 0) return physics.place(body, position, orientation);
  double* to = physics.data().qpos + physics.model().jnt_qposadr[joint];
  if (position != nullptr) std::copy_n(position, 3, to);
  if (orientation != nullptr) std::copy_n(orientation, 4, to + 3);
}

void hold(engine::Physics& physics, int joint, const double* values) {
  const int lock = engine::find_lock(physics.model(), joint);
  if (values[0] != 0) {
    physics.hold(lock, values[1]);
  } else {
    physics.release(lock, values[1]);
  }
}

void copy_narrowed(const double* values, int count, float* to) {
  std::transform(values, values + count, to, [](double value) { return static_cast<float>(value); });
}

// Values are checked, and directions of length 1.
void write(env::World& world, Quantity quantity, int id, const double* values, int count) {
  engine::Physics& physics = world.physics();
  const mjModel& model = physics.model();
  mjData& data = physics.data();
  switch (quantity) {
    case Quantity::kJointPosition: std::copy_n(values, count, data.qpos + model.jnt_qposadr[id]); break;
    case Quantity::kJointVelocity: std::copy_n(values, count, data.qvel + model.jnt_dofadr[id]); break;
    case Quantity::kJointForce: std::copy_n(values, count, data.qfrc_applied + model.jnt_dofadr[id]); break;
    case Quantity::kJointDamping: physics.damp(id, *values); break;
    case Quantity::kJointLock: hold(physics, id, values); break;
    case Quantity::kBodyPosition: place(physics, id, values, nullptr); break;
    case Quantity::kBodyOrientation: place(physics, id, nullptr, values); break;
    case Quantity::kBodyPose: place(physics, id, values, values + 3); break;
    case Quantity::kBodyForce: std::copy_n(values, 6, data.xfrc_applied + 6 * id); break;
    case Quantity::kGeomSize: physics.resize(id, values); break;
    case Quantity::kGeomFriction: std::copy_n(values, 3, physics.friction(id)); break;
    case Quantity::kGeomColor: copy_narrowed(values, 4, physics.color(id)); break;
    case Quantity::kActuatorControl: data.ctrl[id] = *values; break;
    case Quantity::kActuatorGear: physics.gear(id) = *values; break;
    case Quantity::kLightPosition: std::copy_n(values, 3, physics.light_position(id)); break;
    case Quantity::kLightDirection: std::copy_n(values, 3, physics.light_direction(id)); break;
    case Quantity::kLightColor: copy_narrowed(values, 3, physics.light_color(id)); break;
    case Quantity::kAgentFace: world.show_face(static_cast<std::size_t>(id), static_cast<int>(*values)); break;
    case Quantity::kActuatorFusimotorDrive:
      if (auto* drives = drives_of(world, id)) drives->set(id, values);
      break;
    case Quantity::kWorldGravity: physics.set_gravity({values[0], values[1], values[2]}); break;
    case Quantity::kWarningSteps: physics.forget_warnings(id); break;
    default: break;
  }
}

// All at once, for what follows from masses takes a while.
void write_masses(engine::Physics& physics, const Ids& ids, Span<const double> masses) {
  std::vector<std::int32_t> bodies;
  for (std::size_t i = 0; i < ids.size(); ++i) bodies.push_back(ids[i]);
  physics.set_masses(bodies, masses);
}

}  // namespace

void require_writable(Quantity quantity) {
  const Traits& what = traits(quantity);
  require(what.writing != Writing::kNever, "quantity is {}, which can only be read", constant(what));
}

void check_settable(const env::World& world, Quantity quantity, const Ids& ids, Span<const double> values) {
  require_writable(quantity);
  check_finite(values.data(), values.size(), "values");
  const double* from = values.data();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    check_element(world, quantity, ids[i], from);
    from += width(world.model(), &world, quantity, ids[i]);
  }
}

void set(env::World& world, Quantity quantity, const Ids& ids, Span<const double> values) {
  // Values that survive a reset stay writable in a failed world, so that the caller can undo what broke it.
  if (traits(quantity).writing != Writing::kWorld) std::as_const(world).physics().require_usable();
  check_settable(world, quantity, ids, values);
  engine::Physics& physics = world.physics();
  if (quantity == Quantity::kBodyMass) return write_masses(physics, ids, values);
  const double* from = values.data();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int count = width(physics.model(), &world, quantity, ids[i]);
    const int quaternion = quaternion_at(physics.model(), quantity, ids[i]);
    double element[kWidest];
    std::copy_n(from, count, element);
    if (quaternion >= 0) normalise(element + quaternion, 4);
    if (quantity == Quantity::kLightDirection) normalise(element, 3);
    write(world, quantity, ids[i], element, count);
    from += count;
  }
  if (moves_bodies(quantity) && !physics.failed()) physics.update_poses();
}

}  // namespace mimo::access
