// Inside, the numbers of mimo.h are enumerations of the rooms that they concern, so that no room below depends on the
// public header. Here they are compared.
#include "actuation/actuation.h"
#include "base/log.h"
#include "base/status.h"
#include "batch/options.h"
#include "engine/model.h"
#include "engine/physics.h"
#include "env/access.h"
#include "geometry/axes.h"
#include "geometry/texture.h"
#include "growth/growth.h"
#include "mimo/mimo.h"
#include "observation/field.h"
#include "reflexes/table.h"
#include "scene/groups.h"
#include "scene/scene.h"
#include "senses/touch/options.h"
#include "senses/touch/spread.h"
#include "tasks/task.h"

namespace mimo {
namespace {

template <typename Enum>
constexpr bool same(long long number, Enum value) {
  return number == static_cast<long long>(value);
}

static_assert(same(MIMO_OK, Status::kOk));
static_assert(same(MIMO_E_INVALID_ARGUMENT, Status::kInvalidArgument));
static_assert(same(MIMO_E_BAD_HANDLE, Status::kBadHandle));
static_assert(same(MIMO_E_BUFFER_TOO_SMALL, Status::kBufferTooSmall));
static_assert(same(MIMO_E_STRUCT_SIZE, Status::kStructSize));
static_assert(same(MIMO_E_NOT_FOUND, Status::kNotFound));
static_assert(same(MIMO_E_MODEL, Status::kModel));
static_assert(same(MIMO_E_SIMULATION, Status::kSimulation));
static_assert(same(MIMO_E_RENDER, Status::kRender));
static_assert(same(MIMO_E_UNSUPPORTED, Status::kUnsupported));
static_assert(same(MIMO_E_OUT_OF_MEMORY, Status::kOutOfMemory));
static_assert(same(MIMO_E_FORKED, Status::kForked));
static_assert(same(MIMO_E_INTERNAL, Status::kInternal));
static_assert(same(MIMO_E_FILE, Status::kFile));
static_assert(same(MIMO_E_TASK, Status::kTask));
static_assert(same(MIMO_E_BUSY, Status::kBusy));

static_assert(same(MIMO_LOG_WARNING, LogLevel::kWarning));
static_assert(same(MIMO_LOG_INFO, LogLevel::kInfo));

static_assert(same(MIMO_WARNING_CONTACTS_DROPPED, engine::Warning::kContactsDropped));
static_assert(same(MIMO_WARNING_CONSTRAINTS_DROPPED, engine::Warning::kConstraintsDropped));
static_assert(same(MIMO_WARNING_BAD_POSITION, engine::Warning::kBadPosition));
static_assert(same(MIMO_WARNING_BAD_VELOCITY, engine::Warning::kBadVelocity));
static_assert(same(MIMO_WARNING_BAD_ACCELERATION, engine::Warning::kBadAcceleration));
static_assert(same(MIMO_WARNING_BAD_CONTROL, engine::Warning::kBadControl));
static_assert(same(MIMO_WARNING_INERTIA, engine::Warning::kInertia));
static_assert(same(MIMO_WARNING_NOT_CONVERGED, engine::Warning::kNotConverged));
static_assert(same(MIMO_WARNING_NOT_CONVERGED + 1, engine::kWarnings));

static_assert(same(MIMO_SEX_MEAN, growth::Sex::kMean));
static_assert(same(MIMO_SEX_FEMALE, growth::Sex::kFemale));
static_assert(same(MIMO_SEX_MALE, growth::Sex::kMale));
static_assert(same(MIMO_GROWTH_WHO, growth::Model::kWho));
static_assert(same(MIMO_GROWTH_ORIGINAL, growth::Model::kOriginal));

constexpr bool is_bit(unsigned bit, reflexes::Reflex reflex) { return bit == 1U << static_cast<int>(reflex); }
static_assert(is_bit(MIMO_REFLEX_PALMAR_GRASP, reflexes::Reflex::kPalmarGrasp));
static_assert(is_bit(MIMO_REFLEX_PLANTAR_GRASP, reflexes::Reflex::kPlantarGrasp));
static_assert(is_bit(MIMO_REFLEX_ROOTING, reflexes::Reflex::kRooting));
static_assert(is_bit(MIMO_REFLEX_MORO, reflexes::Reflex::kMoro));
static_assert(is_bit(MIMO_REFLEX_ASYMMETRIC_TONIC_NECK, reflexes::Reflex::kTonicNeck));
static_assert(is_bit(MIMO_REFLEX_STEPPING, reflexes::Reflex::kStepping));
static_assert(is_bit(MIMO_REFLEX_WITHDRAWAL, reflexes::Reflex::kWithdrawal));

static_assert(same(MIMO_OUTCOME_NONE, tasks::Outcome::kNone));
static_assert(same(MIMO_OUTCOME_SUCCESS, tasks::Outcome::kSuccess));
static_assert(same(MIMO_OUTCOME_FAILURE, tasks::Outcome::kFailure));

static_assert(same(MIMO_BODY, env::Kind::kBody));
static_assert(same(MIMO_JOINT, env::Kind::kJoint));
static_assert(same(MIMO_GEOM, env::Kind::kGeom));
static_assert(same(MIMO_SITE, env::Kind::kSite));
static_assert(same(MIMO_CAMERA, env::Kind::kCamera));
static_assert(same(MIMO_ACTUATOR, env::Kind::kActuator));
static_assert(same(MIMO_SENSOR, env::Kind::kSensor));
static_assert(same(MIMO_LIGHT, env::Kind::kLight));
static_assert(same(MIMO_CONTACT, env::Kind::kContact));
static_assert(same(MIMO_STEP_CONTACT, env::Kind::kStepContact));
static_assert(same(MIMO_AGENT, env::Kind::kAgent));
static_assert(same(MIMO_FACE, env::Kind::kFace));
static_assert(same(MIMO_WORLD, env::Kind::kWorld));
static_assert(same(MIMO_WARNING, env::Kind::kWarning));
static_assert(same(MIMO_BODY, engine::Kind::kBody));
static_assert(same(MIMO_JOINT, engine::Kind::kJoint));
static_assert(same(MIMO_GEOM, engine::Kind::kGeom));
static_assert(same(MIMO_SITE, engine::Kind::kSite));
static_assert(same(MIMO_CAMERA, engine::Kind::kCamera));
static_assert(same(MIMO_ACTUATOR, engine::Kind::kActuator));
static_assert(same(MIMO_SENSOR, engine::Kind::kSensor));
static_assert(same(MIMO_LIGHT, engine::Kind::kLight));

static_assert(same(MIMO_JACOBIAN_MODEL, engine::Jacobian::kModel));
static_assert(same(MIMO_JACOBIAN_DENSE, engine::Jacobian::kDense));
static_assert(same(MIMO_JACOBIAN_SPARSE, engine::Jacobian::kSparse));

static_assert(same(MIMO_SHAPE_SPHERE, scene::Shape::kSphere));
static_assert(same(MIMO_SHAPE_CAPSULE, scene::Shape::kCapsule));
static_assert(same(MIMO_SHAPE_ELLIPSOID, scene::Shape::kEllipsoid));
static_assert(same(MIMO_SHAPE_CYLINDER, scene::Shape::kCylinder));
static_assert(same(MIMO_SHAPE_BOX, scene::Shape::kBox));

static_assert(same(MIMO_ACT_TRUNK, scene::Group::kTrunk));
static_assert(same(MIMO_ACT_HEAD, scene::Group::kHead));
static_assert(same(MIMO_ACT_EYES, scene::Group::kEyes));
static_assert(same(MIMO_ACT_RIGHT_ARM, scene::Group::kRightArm));
static_assert(same(MIMO_ACT_LEFT_ARM, scene::Group::kLeftArm));
static_assert(same(MIMO_ACT_RIGHT_HAND, scene::Group::kRightHand));
static_assert(same(MIMO_ACT_LEFT_HAND, scene::Group::kLeftHand));
static_assert(same(MIMO_ACT_RIGHT_LEG, scene::Group::kRightLeg));
static_assert(same(MIMO_ACT_LEFT_LEG, scene::Group::kLeftLeg));
static_assert(same(MIMO_ACT_RIGHT_FOOT, scene::Group::kRightFoot));
static_assert(same(MIMO_ACT_LEFT_FOOT, scene::Group::kLeftFoot));

static_assert(same(MIMO_ACTUATION_TORQUE, actuation::Mode::kTorque));
static_assert(same(MIMO_ACTUATION_POSITION, actuation::Mode::kPosition));
static_assert(same(MIMO_ACTUATION_MUSCLE, actuation::Mode::kMuscle));
static_assert(same(MIMO_ACTUATION_MUJOCO_MUSCLE, actuation::Mode::kMujocoMuscle));

static_assert(same(MIMO_RESPONSE_NEAREST, senses::touch::Response::kNearest));
static_assert(same(MIMO_RESPONSE_LINEAR, senses::touch::Response::kLinear));
static_assert(same(MIMO_RESPONSE_GAUSSIAN, senses::touch::Response::kGaussian));

static_assert(same(MIMO_FRAME_BODY, senses::TouchFrame::kBody));
static_assert(same(MIMO_FRAME_WORLD, senses::TouchFrame::kWorld));
static_assert(same(MIMO_FRAME_SKIN, senses::TouchFrame::kSkin));

static_assert(same(MIMO_U8, observation::Type::kU8));
static_assert(same(MIMO_I32, observation::Type::kI32));
static_assert(same(MIMO_F32, observation::Type::kF32));
static_assert(same(MIMO_F64, observation::Type::kF64));

static_assert(same(MIMO_RECEPTOR_BODY, observation::ReceptorQuantity::kBody));
static_assert(same(MIMO_RECEPTOR_GEOM, observation::ReceptorQuantity::kGeom));
static_assert(same(MIMO_RECEPTOR_POSITION, observation::ReceptorQuantity::kPosition));
static_assert(same(MIMO_RECEPTOR_FRAME, observation::ReceptorQuantity::kFrame));
static_assert(same(MIMO_RECEPTOR_FRAME, observation::kReceptorQuantities));

static_assert(same(MIMO_JOINT_POSITION, env::Quantity::kJointPosition));
static_assert(same(MIMO_JOINT_VELOCITY, env::Quantity::kJointVelocity));
static_assert(same(MIMO_JOINT_FORCE, env::Quantity::kJointForce));
static_assert(same(MIMO_JOINT_ACCELERATION, env::Quantity::kJointAcceleration));
static_assert(same(MIMO_JOINT_RANGE, env::Quantity::kJointRange));
static_assert(same(MIMO_BODY_POSITION, env::Quantity::kBodyPosition));
static_assert(same(MIMO_BODY_ORIENTATION, env::Quantity::kBodyOrientation));
static_assert(same(MIMO_BODY_VELOCITY, env::Quantity::kBodyVelocity));
static_assert(same(MIMO_BODY_FORCE, env::Quantity::kBodyForce));
static_assert(same(MIMO_BODY_MASS, env::Quantity::kBodyMass));
static_assert(same(MIMO_BODY_CENTER_OF_MASS, env::Quantity::kBodyCenterOfMass));
static_assert(same(MIMO_GEOM_POSITION, env::Quantity::kGeomPosition));
static_assert(same(MIMO_GEOM_ORIENTATION, env::Quantity::kGeomOrientation));
static_assert(same(MIMO_GEOM_SIZE, env::Quantity::kGeomSize));
static_assert(same(MIMO_SITE_POSITION, env::Quantity::kSitePosition));
static_assert(same(MIMO_SITE_ORIENTATION, env::Quantity::kSiteOrientation));
static_assert(same(MIMO_CAMERA_POSITION, env::Quantity::kCameraPosition));
static_assert(same(MIMO_CAMERA_ORIENTATION, env::Quantity::kCameraOrientation));
static_assert(same(MIMO_ACTUATOR_CONTROL, env::Quantity::kActuatorControl));
static_assert(same(MIMO_ACTUATOR_FORCE, env::Quantity::kActuatorForce));
static_assert(same(MIMO_SENSOR_VALUE, env::Quantity::kSensorValue));
static_assert(same(MIMO_ACTUATOR_GEAR, env::Quantity::kActuatorGear));
static_assert(same(MIMO_BODY_POSE, env::Quantity::kBodyPose));
static_assert(same(MIMO_GEOM_POSE, env::Quantity::kGeomPose));
static_assert(same(MIMO_SITE_POSE, env::Quantity::kSitePose));
static_assert(same(MIMO_CAMERA_POSE, env::Quantity::kCameraPose));
static_assert(same(MIMO_GEOM_FRICTION, env::Quantity::kGeomFriction));
static_assert(same(MIMO_GEOM_COLOR, env::Quantity::kGeomColor));
static_assert(same(MIMO_JOINT_DAMPING, env::Quantity::kJointDamping));
static_assert(same(MIMO_JOINT_LOCK, env::Quantity::kJointLock));
static_assert(same(MIMO_LIGHT_POSITION, env::Quantity::kLightPosition));
static_assert(same(MIMO_LIGHT_DIRECTION, env::Quantity::kLightDirection));
static_assert(same(MIMO_LIGHT_COLOR, env::Quantity::kLightColor));
static_assert(same(MIMO_CONTACT_GEOMS, env::Quantity::kContactGeoms));
static_assert(same(MIMO_CONTACT_BODIES, env::Quantity::kContactBodies));
static_assert(same(MIMO_CONTACT_POSITION, env::Quantity::kContactPosition));
static_assert(same(MIMO_CONTACT_FRAME, env::Quantity::kContactFrame));
static_assert(same(MIMO_CONTACT_DISTANCE, env::Quantity::kContactDistance));
static_assert(same(MIMO_CONTACT_FORCE, env::Quantity::kContactForce));
static_assert(same(MIMO_CONTACT_TORQUE, env::Quantity::kContactTorque));
static_assert(same(MIMO_STEP_CONTACT_GEOMS, env::Quantity::kStepContactGeoms));
static_assert(same(MIMO_STEP_CONTACT_BODIES, env::Quantity::kStepContactBodies));
static_assert(same(MIMO_STEP_CONTACT_START, env::Quantity::kStepContactStart));
static_assert(same(MIMO_STEP_CONTACT_END, env::Quantity::kStepContactEnd));
static_assert(same(MIMO_STEP_CONTACT_IMPULSE, env::Quantity::kStepContactImpulse));
static_assert(same(MIMO_STEP_CONTACT_PEAK_FORCE, env::Quantity::kStepContactPeakForce));
static_assert(same(MIMO_STEP_CONTACT_PEAK_POSITION, env::Quantity::kStepContactPeakPosition));
static_assert(same(MIMO_AGENT_FACE, env::Quantity::kAgentFace));
static_assert(same(MIMO_WORLD_GRAVITY, env::Quantity::kWorldGravity));
static_assert(same(MIMO_WARNING_COUNT, env::Quantity::kWarningCount));
static_assert(same(MIMO_SITE_VELOCITY, env::Quantity::kSiteVelocity));
static_assert(same(MIMO_AGENT_GOAL, env::Quantity::kAgentGoal));
static_assert(same(MIMO_AGENT_ACHIEVED, env::Quantity::kAgentAchieved));
static_assert(same(MIMO_AGENT_AGE, env::Quantity::kAgentAge));
static_assert(same(MIMO_AGENT_PHYSIOLOGICAL_AGE, env::Quantity::kAgentPhysiologicalAge));
static_assert(same(MIMO_BODY_NERVE_LENGTH, env::Quantity::kBodyNerveLength));
static_assert(same(MIMO_ACTUATOR_FUSIMOTOR_DRIVE, env::Quantity::kActuatorFusimotorDrive));
static_assert(same(MIMO_ACTUATOR_FUSIMOTOR_DRIVE, env::kQuantities));
static_assert(same(MIMO_WARNING, env::kKinds));

static_assert(same(MIMO_AXES_MIMO, geometry::Axes::kMimo));
static_assert(same(MIMO_AXES_UNITY, geometry::Axes::kUnity));
static_assert(same(MIMO_AXES_UNREAL, geometry::Axes::kUnreal));
static_assert(same(MIMO_AXES_GODOT, geometry::Axes::kGodot));
static_assert(same(MIMO_AXES_GLTF, geometry::Axes::kGltf));
static_assert(same(MIMO_AXES_GLTF, geometry::kLastAxes));
static_assert(same(MIMO_TEXTURE_FLAT, geometry::TextureType::kFlat));
static_assert(same(MIMO_TEXTURE_CUBE, geometry::TextureType::kCube));
static_assert(same(MIMO_TEXTURE_SKY, geometry::TextureType::kSky));

static_assert(same(MIMO_AUTORESET_NONE, batch::Autoreset::kNone));
static_assert(same(MIMO_AUTORESET_NEXT_STEP, batch::Autoreset::kNextStep));
static_assert(same(MIMO_AUTORESET_SAME_STEP, batch::Autoreset::kSameStep));

}  // namespace
}  // namespace mimo
