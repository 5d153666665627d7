#include "engine/present.h"

#include <algorithm>

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

}  // namespace mimo::engine
