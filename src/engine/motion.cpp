#include "engine/motion.h"

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace mimo::engine {
namespace {

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

}  // namespace

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

}  // namespace mimo::engine
