#include "engine/present.h"

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <array>

#include "base/fail.h"
#include "compat/mujoco.h"

namespace mimo::engine {
namespace {

// Calls visit(array, count) for all that kinematics writes.
template <typename Visit>
void visit_poses(const mjModel& model, Visit&& visit) {
  visit(&mjData::qpos, model.nq);  // quaternions are normalised
  visit(&mjData::xpos, 3 * model.nbody);
  visit(&mjData::xquat, 4 * model.nbody);
  visit(&mjData::xmat, 9 * model.nbody);
  visit(&mjData::xipos, 3 * model.nbody);
  visit(&mjData::ximat, 9 * model.nbody);
  visit(&mjData::xanchor, 3 * model.njnt);
  visit(&mjData::xaxis, 3 * model.njnt);
  visit(&mjData::geom_xpos, 3 * model.ngeom);
  visit(&mjData::geom_xmat, 9 * model.ngeom);
  visit(&mjData::site_xpos, 3 * model.nsite);
  visit(&mjData::site_xmat, 9 * model.nsite);
  visit(&mjData::cam_xpos, 3 * model.ncam);
  visit(&mjData::cam_xmat, 9 * model.ncam);
  visit(&mjData::light_xpos, 3 * model.nlight);
  visit(&mjData::light_xdir, 3 * model.nlight);
  visit(&mjData::subtree_com, 3 * model.nbody);
  visit(&mjData::cdof, 6 * model.nv);
  visit(&mjData::cinert, 10 * model.nbody);
  visit(&mjData::cvel, 6 * model.nbody);
  visit(&mjData::cdof_dot, 6 * model.nv);
  compat::visit_more_poses(model, visit);
}

// What these functions take from MuJoCo's stack, and more.
int stack_size(const mjModel& model) { return 32 * (model.nbody + model.nv) + 1024; }

using Spatial = Eigen::Matrix<double, 6, 1>;  // angular, then linear, about the centre of mass of the whole tree
using Vec3 = Eigen::Vector3d;

Spatial spatial(const mjtNum* values) { return Eigen::Map<const Spatial>(values); }

// The part of a body's acceleration that comes from how fast its joints turn. After a step of MuJoCo qvel is already
// that of the end, while everything else is of the start: the velocities of then are what explains the bodies' motion.
Spatial velocity_product(const mjModel& model, const mjData& data, int body) {
  const int count = model.body_dofnum[body];
  const int first = model.body_dofadr[body];
  using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  const Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>> axes(data.cdof + 6 * first, 6, count);
  const Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>> turning(data.cdof_dot + 6 * first, 6, count);
  const Spatial gained = spatial(data.cvel + 6 * body) - spatial(data.cvel + 6 * model.body_parentid[body]);
  const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1> velocities =
      Eigen::ColPivHouseholderQR<Columns>(axes).solve(gained);
  return turning * velocities;
}

// Gravity counts as an acceleration of the world upwards. As mj_rnePostConstraint, which only runs for models with
// sensors that need it.
Spatial acceleration_of(const mjModel& model, const mjData& data, int body) {
  Spatial sum = Spatial::Zero();
  for (int link = body; link > 0; link = model.body_parentid[link]) {
    if (model.body_dofnum[link] == 0) continue;
    sum += velocity_product(model, data, link);
    const int first = model.body_dofadr[link];
    for (int dof = first; dof < first + model.body_dofnum[link]; ++dof) {
      sum += data.qacc[dof] * spatial(data.cdof + 6 * dof);
    }
  }
  const bool weightless = (model.opt.disableflags & mjDSBL_GRAVITY) != 0;
  if (!weightless) sum.tail<3>() -= Eigen::Map<const Vec3>(model.opt.gravity);
  return sum;
}

using Parameters = std::array<mjtNum, 9>;

// In the order of MuJoCo's gainprm: range, force, scale, lmin, lmax, vmax, fpmax, fvmax. The scale is for a force that
// is not given.
Parameters parameters(const MuscleShape& shape) {
  return {shape.short_end, shape.long_end, shape.peak_force, 0, shape.shortest, shape.longest,
          shape.fastest,   shape.passive,  shape.stretched};
}

}  // namespace

void Present::make_room(const mjModel& model) {
  if (data_ != nullptr) return;
  std::size_t size = static_cast<std::size_t>(stack_size(model));
  visit_poses(model, [&](auto, int count) { size += static_cast<std::size_t>(count); });
  numbers_.resize(size);
  data_ = std::make_unique<mjData>();
}

const mjData& Present::of(const Physics& physics) {
  physics.require_usable();
  return of(physics.model(), physics.data());
}

const mjData& Present::of(const mjModel& model, const mjData& data) {
  make_room(model);
  *data_ = data;
  double* next = numbers_.data();
  visit_poses(model, [&](auto array, int count) {
    std::copy_n(data.*array, count, next);
    (*data_).*array = next;
    next += count;
  });
  compat::give_stack(*data_, next, stack_size(model));
  const Complaint complaint = guarded([&] {
    mj_kinematics(&model, data_.get());
    mj_comPos(&model, data_.get());
    mj_camlight(&model, data_.get());
    mj_comVel(&model, data_.get());
  });
  if (complaint.failed) fail(Status::kSimulation, "poses cannot be computed: {}", complaint.error.data());
  return *data_;
}

Motion motion_of(const mjModel& model, const mjData& data, const Place& place) {
  const bool site = place.kind == Kind::kSite;
  const int body = site ? model.site_bodyid[place.id] : place.id;
  const Vec3 position((site ? data.site_xpos : data.xpos) + 3 * place.id);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame((site ? data.site_xmat : data.xmat) +
                                                                             9 * place.id);
  const Vec3 offset = position - Vec3(data.subtree_com + 3 * model.body_rootid[body]);
  const Spatial velocity = spatial(data.cvel + 6 * body);
  const Spatial acceleration = acceleration_of(model, data, body);
  const Vec3 spin = velocity.head<3>();
  const Vec3 speed = velocity.tail<3>() + spin.cross(offset);
  // Spatial accelerations are those of a point fixed in space; the place itself also turns.
  const Vec3 linear = acceleration.tail<3>() + acceleration.head<3>().cross(offset) + spin.cross(speed);
  return {frame.transpose() * linear, frame.transpose() * spin, frame.transpose() * acceleration.head<3>()};
}

Vec3 acceleration_at(const Motion& motion, const Vec3& point) {
  const Vec3& spin = motion.angular_velocity;
  return motion.acceleration + motion.angular_acceleration.cross(point) + spin.cross(spin.cross(point));
}

double muscle_active_force(const MuscleShape& shape, double length, double velocity) {
  const Parameters prm = parameters(shape);
  const std::array<mjtNum, 2> range = {shape.short_end, shape.long_end};
  return -mju_muscleGain(length, velocity, range.data(), 1, prm.data());
}

double muscle_passive_force(const MuscleShape& shape, double length) {
  const Parameters prm = parameters(shape);
  const std::array<mjtNum, 2> range = {shape.short_end, shape.long_end};
  return -mju_muscleBias(length, range.data(), 1, prm.data());
}

double muscle_activation_rate(double control, double activation, double rise, double fall) {
  const std::array<mjtNum, 3> prm = {rise, fall, 0};  // newer versions have a third: how smoothly one becomes the other
  return mju_muscleDynamics(control, activation, prm.data());
}

}  // namespace mimo::engine
