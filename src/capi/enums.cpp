// Inside, the numbers of mimo.h are enumerations of the rooms that they concern, so that no room below depends on the
// public header. Here they are compared.
#include "access/kinds.h"
#include "actuation/actuation.h"
#include "base/log.h"
#include "base/status.h"
#include "batch/options.h"
#include "engine/model.h"
#include "engine/physics.h"
#include "geometry/axes.h"
#include "geometry/texture.h"
#include "growth/growth.h"
#include "mimo/experimental.h"
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
static_assert(same(MIMO_E_MISMATCH, Status::kMismatch));
static_assert(same(MIMO_E_END, Status::kEnd));

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
