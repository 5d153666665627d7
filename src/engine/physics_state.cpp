// Physics::save and load.
#include <algorithm>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "engine/guard.h"
#include "engine/physics.h"

namespace mimo::engine {
namespace {

// Calls visit(name, numbers, count) for everything that a step starts from. All else follows from it.
template <typename Data, typename Visit>
void visit_state(const mjModel& model, Data& data, Visit&& visit) {
  visit("time", &data.time, 1);
  visit("qpos", data.qpos, model.nq);
  visit("qvel", data.qvel, model.nv);
  visit("act", data.act, model.na);
  visit("qacc_warmstart", data.qacc_warmstart, model.nv);
  visit("ctrl", data.ctrl, model.nu);
  visit("qfrc_applied", data.qfrc_applied, model.nv);
  visit("xfrc_applied", data.xfrc_applied, 6 * model.nbody);
  visit("mocap_pos", data.mocap_pos, 3 * model.nmocap);
  visit("mocap_quat", data.mocap_quat, 4 * model.nmocap);
  visit("userdata", data.userdata, model.nuserdata);
  compat::visit_more_state(model, data, visit);
}

void clear(mjtNum* numbers, int count) { std::fill_n(numbers, count, 0.0); }

}  // namespace

void Physics::save(ByteWriter& to) const {
  visit_state(model_, *data_, [&to](const char*, const mjtNum* numbers, int count) {
    to.put(Span<const double>(numbers, static_cast<std::size_t>(count)));
  });
}

void Physics::check(ByteReader& from) const {
  visit_state(model_, *data_, [&from](const char* name, const mjtNum*, int count) {
    for (int i = 0; i < count; ++i) from.take_finite(name);
  });
}

void Physics::load(ByteReader& from) {
  // A step that broke off in the middle leaves its marks everywhere.
  if (failed_) run([this] { mj_resetData(&model_, data_.get()); });
  failed_ = false;
  visit_state(model_, *data_, [&from](const char*, mjtNum* numbers, int count) {
    from.take(Span<double>(numbers, static_cast<std::size_t>(count)));
  });
  update_poses();
  run([this] { mj_comVel(&model_, data_.get()); });
  forget_derived();
}

// What senses and named access could read of the time before: nothing of it may show through.
void Physics::forget_derived() {
  mjData& data = *data_;
  data.ne = data.nf = data.nefc = data.ncon = 0;
  clear(data.qacc, model_.nv);
  clear(data.sensordata, model_.nsensordata);
  clear(data.actuator_force, model_.nu);
  clear(data.cacc, 6 * model_.nbody);
  clear(data.cfrc_int, 6 * model_.nbody);
  clear(data.cfrc_ext, 6 * model_.nbody);
  std::fill(std::begin(data.warning), std::end(data.warning), mjWarningStat{});
  warned_.fill(0);
}

}  // namespace mimo::engine
