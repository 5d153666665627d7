#include "access/quantities.h"

#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "access/columns.h"
#include "base/fail.h"
#include "base/header.h"
#include "body/body.h"
#include "engine/contacts.h"
#include "engine/overrides.h"
#include "engine/present.h"
#include "senses/fusimotor_drives.h"

namespace mimo::access {
namespace {

using env::World;

// ---- What rows share ------------------------------------------------------------------------------------------------

double norm(const double* numbers, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += numbers[i] * numbers[i];
  return std::sqrt(sum);
}

// Numbers whose squares are too large for a double have a direction too.
template <std::size_t count>
std::array<double, count> normalised(const double* numbers) {
  std::array<double, count> unit{};
  const double scale = std::isinf(norm(numbers, count)) ? 1e-200 : 1;
  std::transform(numbers, numbers + count, unit.begin(), [scale](double x) { return x * scale; });
  const double length = norm(unit.data(), count);
  for (double& x : unit) x /= length;
  return unit;
}

void check_quaternion(const char* whose, int id, const double* quaternion) {
  require(norm(quaternion, 4) > 1e-9, "values: the quaternion of {} {} is zero", whose, id);
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

// ---- Bodies ---------------------------------------------------------------------------------------------------------

// The free joint of a body, by which it can be moved; -1 if it has none.
int free_joint(const mjModel& model, int body) {
  const int joint = model.body_jntadr[body];
  return joint >= 0 && model.jnt_type[joint] == mjJNT_FREE ? joint : -1;
}

// Stands on the world and cannot move in it.
bool is_fixed(const mjModel& model, int body) {
  return body > 0 && model.body_parentid[body] == 0 && model.body_jntnum[body] == 0;
}

void check_place(const World& world, int body, const double* /*values*/) {
  const mjModel& model = world.model();
  require(free_joint(model, body) >= 0 || is_fixed(model, body),
          "body {} (\"{}\") cannot be moved: it has no free joint, and is not fixed to the world", body,
          engine::name(model, engine::Kind::kBody, body));
}

// The quaternion is the last four of so many values.
template <int count>
void check_turn(const World& world, int body, const double* values) {
  check_place(world, body, values);
  check_quaternion("body", body, values + count - 4);
}

// Null: it stays.
void place(World& world, int body, const double* position, const double* orientation) {
  engine::Physics& physics = world.physics();
  std::array<double, 4> unit{};
  if (orientation != nullptr) orientation = (unit = normalised<4>(orientation)).data();
  const int joint = free_joint(physics.model(), body);
  if (joint < 0) return physics.place(body, position, orientation);
  double* to = physics.data().qpos + physics.model().jnt_qposadr[joint];
  if (position != nullptr) std::copy_n(position, 3, to);
  if (orientation != nullptr) std::copy_n(orientation, 4, to + 3);
}

// What is there already may be written back.
void check_mass(const World& world, int body, const double* values) {
  const mjModel& model = world.model();
  const double mass = *values;
  if (mass == model.body_mass[body]) return;
  const char* name = engine::name(model, engine::Kind::kBody, body);
  require(body > 0 && model.body_mass[body] > 0, "body {} (\"{}\") has no mass to change", body, name);
  require(mass > 0, "values: the mass of body {} (\"{}\") is {}, expected kilograms above 0", body, name, mass);
}

// All at once, as computing what follows from masses takes a while.
void set_masses(World& world, const Ids& ids, Span<const double> masses) {
  std::vector<std::int32_t> bodies;
  for (std::size_t i = 0; i < ids.size(); ++i) bodies.push_back(ids[i]);
  world.physics().set_masses(bodies, masses);
}

void read_inertial(const Element& body, double* to) {
  const engine::Motion motion = engine::motion_of(body.model, body.data, {engine::Kind::kBody, body.id});
  copy(motion.acceleration, to);
  copy(motion.angular_velocity, to + 3);
  copy(motion.angular_acceleration, to + 6);
}

// ---- Joints ---------------------------------------------------------------------------------------------------------

int position_count(const mjModel& model, const World* /*world*/, int joint) {
  return engine::position_count(model.jnt_type[joint]);
}

int velocity_count(const mjModel& model, const World* /*world*/, int joint) {
  return engine::velocity_count(model.jnt_type[joint]);
}

void check_joint_position(const World& world, int joint, const double* values) {
  const int quaternion = engine::quaternion_place(world.model().jnt_type[joint]);
  if (quaternion >= 0) check_quaternion("joint", joint, values + quaternion);
}

void set_joint_position(World& world, int joint, const double* values) {
  const mjModel& model = world.model();
  const int type = model.jnt_type[joint], quaternion = engine::quaternion_place(type);
  double* to = world.physics().data().qpos + model.jnt_qposadr[joint];
  std::copy_n(values, engine::position_count(type), to);
  if (quaternion < 0) return;
  const auto unit = normalised<4>(values + quaternion);
  std::copy(unit.begin(), unit.end(), to + quaternion);
}

void read_range(const Element& joint, double* to) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double* range = joint.model.jnt_range + 2 * joint.id;
  const bool limited = joint.model.jnt_limited[joint.id] != 0;
  to[0] = limited ? range[0] : -infinity;
  to[1] = limited ? range[1] : infinity;
}

void read_lock(const Element& joint, double* to) {
  const int lock = engine::find_lock(joint.model, joint.id);
  to[0] = lock >= 0 && engine::is_held(joint.model, lock) ? 1 : 0;
  to[1] = lock < 0 ? 0.0 : engine::lock_angle(joint.model, lock);
}

void check_lock(const World& world, int joint, const double* values) {
  const mjModel& model = world.model();
  const char* name = engine::name(model, engine::Kind::kJoint, joint);
  const int lock = engine::find_lock(model, joint);
  if (lock < 0)
    fail(Status::kUnsupported, "joint {} (\"{}\") has no equality constraint in the model that could hold it", joint,
         name);
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

void set_lock(World& world, int joint, const double* values) {
  engine::Physics& physics = world.physics();
  const int lock = engine::find_lock(physics.model(), joint);
  if (values[0] != 0) {
    physics.hold(lock, values[1]);
  } else {
    physics.release(lock, values[1]);
  }
}

// ---- Geoms and lights -----------------------------------------------------------------------------------------------

void check_size(const World& world, int geom, const double* size) {
  const mjModel& model = world.model();
  if (std::equal(size, size + 3, model.geom_size + 3 * geom)) return;
  const int count = engine::size_count(model.geom_type[geom]);
  const char* name = engine::name(model, engine::Kind::kGeom, geom);
  require(count > 0, "geom {} (\"{}\") is a plane, mesh or height field, whose size cannot be changed", geom, name);
  for (int i = 0; i < count; ++i) {
    require(size[i] > 0, "values: size {} of geom {} (\"{}\") is {}, expected metres above 0", i, geom, name, size[i]);
  }
}

void check_light(const mjModel& model, int light, bool follows) {
  if (!follows) return;
  fail(Status::kUnsupported, "light {} (\"{}\") cannot be moved or turned: it follows a body", light,
       engine::name(model, engine::Kind::kLight, light));
}

void check_light_position(const World& world, int light, const double* /*values*/) {
  const int mode = world.model().light_mode[light];
  check_light(world.model(), light, mode == mjCAMLIGHT_TRACK || mode == mjCAMLIGHT_TRACKCOM);
}

void check_light_direction(const World& world, int light, const double* values) {
  check_light(world.model(), light, world.model().light_mode[light] != mjCAMLIGHT_FIXED);
  require(norm(values, 3) > 1e-9, "values: the direction of light {} is zero", light);
}

void turn_light(World& world, int light, const double* direction) {
  write_own<&engine::Physics::light_direction, 3>(world, light, normalised<3>(direction).data());
}

// ---- Motors and sensors ---------------------------------------------------------------------------------------------

// Whose spindles a motor has; null: nobody's.
senses::FusimotorDrives* drives_of(const World* world, int motor) {
  if (world == nullptr) return nullptr;
  for (const env::Agent& agent : world->agents()) {
    if (agent.drives && agent.drives->has(motor)) return agent.drives.get();
  }
  return nullptr;
}

int drive_count(const mjModel& /*model*/, const World* world, int motor) {
  return drives_of(world, motor) == nullptr ? 0 : senses::FusimotorDrives::kNumbers;
}

void read_drive(const Element& motor, double* to) {
  if (const auto* drives = drives_of(motor.world, motor.id)) drives->get(motor.id, to);
}

void check_drive(const World& world, int motor, const double* values) {
  check_between("fusimotor drive of actuator", motor, values, drive_count(world.model(), &world, motor), 0,
                receptors::kMostFusimotorDrive);
}

void set_drive(World& world, int motor, const double* values) {
  if (auto* drives = drives_of(&world, motor)) drives->set(motor, values);
}

int sensor_dimension(const mjModel& model, const World* /*world*/, int sensor) { return model.sensor_dim[sensor]; }

// ---- Contacts and agents --------------------------------------------------------------------------------------------

engine::Meeting met(const Element& one) { return engine::meeting(one.model, one.data, one.id); }

// From number `first` of its force and torque.
template <int first>
constexpr Computed kContactForce{[](const Element& one, double* to) {
                                   const auto force = engine::contact_force(one.model, one.data, one.id);
                                   std::copy_n(force.data() + first, 3, to);
                                 },
                                 3};

const env::Agent& agent_of(const World* world, int id) { return world->agents()[static_cast<std::size_t>(id)]; }
const env::Agent& agent_of(const Element& one) { return agent_of(one.world, one.id); }

int goal_count(const mjModel& /*model*/, const World* world, int id) { return agent_of(world, id).task->goal_size(); }
int age_count(const mjModel& /*model*/, const World* world, int id) { return agent_of(world, id).age ? 1 : 0; }

void check_face(const World& world, int agent, const double* values) {
  const double face = *values;
  const env::Agent& whose = agent_of(&world, agent);
  if (whose.faces.geom < 0) fail(Status::kUnsupported, "agent {} (\"{}\") has no face", agent, whose.name);
  const auto count = static_cast<double>(world.faces().size());
  require(face >= 0 && face < count && face == std::floor(face), "values: the face is {}, expected 0 to {}", face,
          count - 1);
}

// ---- The table, in the order of numbers -----------------------------------------------------------------------------

#define QUANTITY(constant, ...) row(constant, #constant, __VA_ARGS__)

constexpr Moment kPose = Moment::kPose, kStep = Moment::kStep;
constexpr Writing kState = Writing::kState, kKept = Writing::kWorld;

constexpr Quantity kTable[] = {
    QUANTITY(
        MIMO_BODY_POSITION, In{"m"}, Spatial::kPosition, kPose, kStored<&mjData::xpos, 3>,
        Written{kState, [](World& world, int id, const double* to) { place(world, id, to, nullptr); }, check_place},
        Moves{}),
    QUANTITY(
        MIMO_BODY_ORIENTATION, Spatial::kOrientation, kPose, kStored<&mjData::xquat, 4>,
        Written{kState, [](World& world, int id, const double* to) { place(world, id, nullptr, to); }, check_turn<4>},
        Moves{}),
    QUANTITY(MIMO_BODY_VELOCITY, 6, Spatial::kVelocity, kPose, Computed{[](const Element& one, double* to) {
               copy(engine::body_velocity(one.model, one.data, one.id), to);
             }}),
    QUANTITY(MIMO_BODY_FORCE, Frame{"world"}, kStored<&mjData::xfrc_applied, 6>,
             Written{kState, write_stored<&mjData::xfrc_applied, 6>}),
    QUANTITY(MIMO_BODY_MASS, In{"kg"}, kStored<&mjModel::body_mass, 1>, AllWritten{kKept, set_masses, check_mass}),
    QUANTITY(MIMO_BODY_CENTER_OF_MASS, In{"m"}, Spatial::kPosition, kPose, kStored<&mjData::xipos, 3>),
    QUANTITY(
        MIMO_BODY_POSE, 7, Spatial::kPose, kPose, Computed{[](const Element& one, double* to) {
          std::copy_n(one.data.xquat + 4 * one.id, 4, std::copy_n(one.data.xpos + 3 * one.id, 3, to));
        }},
        Written{kState, [](World& world, int id, const double* to) { place(world, id, to, to + 3); }, check_turn<7>},
        Moves{}),
    QUANTITY(MIMO_BODY_NERVE_LENGTH, 1, In{"m"},
             Computed{[](const Element& one, double* to) { *to = body::nerve_length(one.model, one.id); }}),
    QUANTITY(MIMO_BODY_INERTIAL, 9, Frame{"body"}, kStep, Computed{read_inertial}),

    QUANTITY(MIMO_JOINT_POSITION, position_count, In{"rad", "m"}, kStoredAt<&mjData::qpos, &mjModel::jnt_qposadr>,
             Written{kState, set_joint_position, check_joint_position}, Moves{}),
    QUANTITY(MIMO_JOINT_VELOCITY, velocity_count, In{"rad/s", "m/s"}, kStoredAt<&mjData::qvel, &mjModel::jnt_dofadr>,
             Written{kState, write_axes<&mjData::qvel>}),
    QUANTITY(MIMO_JOINT_FORCE, velocity_count, In{"Nm", "N"}, kStoredAt<&mjData::qfrc_applied, &mjModel::jnt_dofadr>,
             Written{kState, write_axes<&mjData::qfrc_applied>}),
    QUANTITY(MIMO_JOINT_ACCELERATION, velocity_count, In{"rad/s^2", "m/s^2"}, kStep,
             kStoredAt<&mjData::qacc, &mjModel::jnt_dofadr>),
    QUANTITY(MIMO_JOINT_RANGE, 2, In{"rad", "m"}, Computed{read_range}),
    QUANTITY(MIMO_JOINT_DAMPING, 1, In{"Nms/rad", "Ns/m"}, kStoredAt<&mjModel::dof_damping, &mjModel::jnt_dofadr>,
             Written{kKept, [](World& world, int id, const double* to) { world.physics().damp(id, *to); },
                     [](const World& /*world*/, int id, const double* values) {
                       check_not_negative("damping of joint", id, values, 1);
                     }}),
    QUANTITY(MIMO_JOINT_LOCK, 2, Computed{read_lock}, Written{kKept, set_lock, check_lock}),

    QUANTITY(MIMO_GEOM_POSITION, In{"m"}, Spatial::kPosition, kPose, kStored<&mjData::geom_xpos, 3>),
    QUANTITY(MIMO_GEOM_ORIENTATION, Spatial::kOrientation, kPose, kOrientationOf<&mjData::geom_xmat>),
    QUANTITY(
        MIMO_GEOM_SIZE, In{"m"}, kStored<&mjModel::geom_size, 3>,
        Written{kKept, [](World& world, int id, const double* to) { world.physics().resize(id, to); }, check_size}),
    QUANTITY(MIMO_GEOM_POSE, Spatial::kPose, kPose, kPoseOf<&mjData::geom_xpos, &mjData::geom_xmat>),
    QUANTITY(MIMO_GEOM_FRICTION, kStored<&mjModel::geom_friction, 3>,
             Written{kKept, write_own<&engine::Physics::friction, 3>,
                     [](const World& /*world*/, int id, const double* values) {
                       check_not_negative("friction of geom", id, values, 3);
                     }}),
    QUANTITY(MIMO_GEOM_COLOR, kFloats<&mjModel::geom_rgba, 4>,
             Written{kKept, write_own<&engine::Physics::color, 4>,
                     [](const World& /*world*/, int id, const double* values) {
                       check_between("color of geom", id, values, 4, 0, 1);
                     }}),

    QUANTITY(MIMO_SITE_POSITION, In{"m"}, Spatial::kPosition, kPose, kStored<&mjData::site_xpos, 3>),
    QUANTITY(MIMO_SITE_ORIENTATION, Spatial::kOrientation, kPose, kOrientationOf<&mjData::site_xmat>),
    QUANTITY(MIMO_SITE_POSE, Spatial::kPose, kPose, kPoseOf<&mjData::site_xpos, &mjData::site_xmat>),
    QUANTITY(MIMO_SITE_VELOCITY, 6, Spatial::kVelocity, kPose, Computed{[](const Element& one, double* to) {
               copy(engine::site_velocity(one.model, one.data, one.id), to);
             }}),

    QUANTITY(MIMO_CAMERA_POSITION, In{"m"}, Spatial::kPosition, kPose, kStored<&mjData::cam_xpos, 3>),
    QUANTITY(MIMO_CAMERA_ORIENTATION, Spatial::kOrientation, kPose, kOrientationOf<&mjData::cam_xmat>),
    QUANTITY(MIMO_CAMERA_POSE, Spatial::kPose, kPose, kPoseOf<&mjData::cam_xpos, &mjData::cam_xmat>),

    QUANTITY(MIMO_ACTUATOR_CONTROL, kStored<&mjData::ctrl, 1>, Written{kState, write_stored<&mjData::ctrl, 1>}),
    QUANTITY(MIMO_ACTUATOR_FORCE, kStep, kStored<&mjData::actuator_force, 1>),
    QUANTITY(MIMO_ACTUATOR_GEAR, 1, kStored<&mjModel::actuator_gear, 6>,
             Written{kKept, [](World& world, int id, const double* to) { world.physics().gear(id) = *to; }}),
    QUANTITY(MIMO_ACTUATOR_FUSIMOTOR_DRIVE, drive_count, In{"Hz"}, Computed{read_drive},
             Written{kState, set_drive, check_drive}),

    QUANTITY(MIMO_SENSOR_VALUE, sensor_dimension, kStep, kStoredAt<&mjData::sensordata, &mjModel::sensor_adr>),

    QUANTITY(MIMO_LIGHT_POSITION, In{"m"}, kStored<&mjModel::light_pos, 3>,
             Written{kKept, write_own<&engine::Physics::light_position, 3>, check_light_position}, Moves{}),
    QUANTITY(MIMO_LIGHT_DIRECTION, kStored<&mjModel::light_dir, 3>, Written{kKept, turn_light, check_light_direction},
             Moves{}),
    QUANTITY(MIMO_LIGHT_COLOR, kFloats<&mjModel::light_diffuse, 3>,
             Written{kKept, write_own<&engine::Physics::light_color, 3>,
                     [](const World& /*world*/, int id, const double* values) {
                       check_between("color of light", id, values, 3, 0, 100);
                     }}),

    QUANTITY(MIMO_CONTACT_GEOMS, 2, kStep, Computed{[](const Element& one, double* to) { copy(met(one).geoms, to); }}),
    QUANTITY(MIMO_CONTACT_BODIES, 2, kStep,
             Computed{[](const Element& one, double* to) { copy(met(one).bodies, to); }}),
    QUANTITY(MIMO_CONTACT_POSITION, 3, kStep,
             Stored{[](const Element& one) -> const double* { return one.data.contact[one.id].pos; }}),
    QUANTITY(MIMO_CONTACT_FRAME, 9, kStep,
             Stored{[](const Element& one) -> const double* { return one.data.contact[one.id].frame; }}),
    QUANTITY(MIMO_CONTACT_DISTANCE, 1, kStep, Computed{[](const Element& one, double* to) {
               *to = -engine::overlap_of(one.model, one.data, met(one));
             }}),
    QUANTITY(MIMO_CONTACT_FORCE, kStep, kContactForce<0>),
    QUANTITY(MIMO_CONTACT_TORQUE, kStep, kContactForce<3>),

    QUANTITY(MIMO_STEP_CONTACT_GEOMS, 2, kStep, kOfStepContact<&env::StepContact::geoms>),
    QUANTITY(MIMO_STEP_CONTACT_BODIES, 2, kStep, kOfStepContact<&env::StepContact::bodies>),
    QUANTITY(MIMO_STEP_CONTACT_START, 1, kStep, kOfStepContact<&env::StepContact::start>),
    QUANTITY(MIMO_STEP_CONTACT_END, 1, kStep, kOfStepContact<&env::StepContact::end>),
    QUANTITY(MIMO_STEP_CONTACT_IMPULSE, 3, kStep, kOfStepContact<&env::StepContact::impulse>),
    QUANTITY(MIMO_STEP_CONTACT_PEAK_FORCE, 3, kStep, kOfStepContact<&env::StepContact::peak_force>),
    QUANTITY(MIMO_STEP_CONTACT_PEAK_POSITION, 3, kStep, kOfStepContact<&env::StepContact::peak_position>),

    QUANTITY(MIMO_AGENT_FACE, 1,
             Computed{[](const Element& one, double* to) { *to = one.world->face(static_cast<std::size_t>(one.id)); }},
             Written{kKept,
                     [](World& world, int id,
                        const double* to) { world.show_face(static_cast<std::size_t>(id), static_cast<int>(*to)); },
                     check_face}),
    QUANTITY(MIMO_AGENT_GOAL, goal_count, kStep,
             Computed{[](const Element& one, double* to) { agent_of(one).task->goal(one.data, to); }}),
    QUANTITY(MIMO_AGENT_ACHIEVED, goal_count, kStep,
             Computed{[](const Element& one, double* to) { agent_of(one).task->achieved(one.data, to); }}),
    QUANTITY(MIMO_AGENT_AGE, age_count, In{"months"},
             Computed{[](const Element& one, double* to) { *to = agent_of(one).age->body; }}),
    QUANTITY(MIMO_AGENT_PHYSIOLOGICAL_AGE, age_count, In{"months"},
             Computed{[](const Element& one, double* to) { *to = agent_of(one).age->physiology; }}),

    QUANTITY(MIMO_WORLD_GRAVITY, 3, In{"m/s^2"},
             Stored{[](const Element& one) -> const double* { return one.model.opt.gravity; }},
             Written{kKept, [](World& world, int /*id*/,
                               const double* to) { world.physics().set_gravity({to[0], to[1], to[2]}); }}),

    QUANTITY(MIMO_WARNING_STEPS, 1, Computed{[](const Element& one, double* to) {
               *to = static_cast<double>(one.world->physics().warnings()[static_cast<std::size_t>(one.id)]);
             }},
             Written{kState, [](World& world, int id, const double* /*zero*/) { world.physics().forget_warnings(id); },
                     [](const World& /*world*/, int id, const double* values) {
                       check_between("steps of warning", id, values, 1, 0, 0);
                     }}),
};

static_assert(are_rows_of(kTable, header::kQuantities), "a quantity's row is missing, doubled or not in its place");

#ifndef __SANITIZE_ADDRESS__  // there GCC does not know when it compiles that a function's address is not null

// Which is how many numbers, and of what, to see it from another frame.
constexpr int width_in(Spatial space) {
  switch (space) {
    case Spatial::kNone: return 0;
    case Spatial::kPosition: return 3;
    case Spatial::kOrientation: return 4;
    case Spatial::kVelocity: return 6;
    case Spatial::kPose: return 7;
  }
  return -1;
}

constexpr bool rows_are_whole() {
  for (const Quantity& row : kTable) {
    const bool read = (row.stored == nullptr) != (row.compute == nullptr);
    const bool wide = (row.width == 0) != (row.width_of == nullptr) && row.width <= kWidest;
    const bool seen = row.spatial == Spatial::kNone || row.width == width_in(row.spatial);
    const bool written = (row.writing != Writing::kNever) == ((row.write == nullptr) != (row.write_all == nullptr));
    if (!read || !wide || !seen || !written) return false;
  }
  return true;
}
static_assert(rows_are_whole(), "a quantity has no width, no reader or writer, or two of them");

#endif

}  // namespace

const Quantity* find_quantity(mimo_quantity number) {
  const Quantity* found = std::lower_bound(std::begin(kTable), std::end(kTable), number,
                                           [](const Quantity& row, mimo_quantity one) { return row.number < one; });
  return found != std::end(kTable) && found->number == number ? found : nullptr;
}

const Quantity& quantity_of(mimo_quantity number) { return *find_quantity(number); }

std::size_t width(const World& world, const Quantity& quantity, const Ids& ids) {
  const int limit = quantity.kind().count(world);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int id = ids[i];
    if (id < 0 || id >= limit) {
      fail(Status::kInvalidArgument, "ids[{}] is {}, expected a {} id from 0 to {}", i, id,
           words(quantity.kind().constant), limit - 1);
    }
    sum += static_cast<std::size_t>(width(quantity, world.model(), &world, id));
  }
  return sum;
}

}  // namespace mimo::access
