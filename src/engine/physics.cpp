#include "engine/physics.h"

#include <algorithm>
#include <type_traits>

#include "base/fail.h"
#include "compat/mujoco.h"
#include "engine/data.h"
#include "engine/guard.h"
#include "engine/hooks.h"
#include "solver/newton.h"

namespace mimo::engine {
namespace {

// MuJoCo resets a diverged state and reports that in these counters; the library marks the world as failed.
constexpr mjtWarning kDivergence[] = {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC};

bool diverged(const mjData& data) {
  return std::any_of(std::begin(kDivergence), std::end(kDivergence),
                     [&](mjtWarning kind) { return data.warning[kind].number > 0; });
}

// As mj_step notes it, which takes the state back as well.
void note_bad(mjData& data, WarningCounts& counts, mjtWarning kind, const double* values, int count) {
  const int bad = first_bad(values, count);
  if (bad < 0) return;
  data.warning[kind].lastinfo = bad;
  ++data.warning[kind].number;
  ++counts[static_cast<std::size_t>(kind_of(kind))];
}

// It lives across a call that may be left by longjmp (engine/guard.h).
static_assert(std::is_trivially_destructible_v<WarningWatch>);

// Trouble that the simulation survives, but that its user must hear of.
constexpr mjtWarning kSurvivable[] = {mjWARN_INERTIA, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL, mjWARN_BADCTRL};

// MuJoCo's own texts come from one buffer for all threads.
std::string text_of(mjtWarning kind, const mjWarningStat& stat) {
  const std::string info = std::to_string(stat.lastinfo);
  switch (kind) {
    case mjWARN_INERTIA: return "the inertia matrix is nearly singular at degree of freedom " + info;
    case mjWARN_CONTACTFULL: return "the contact buffer is full: raise " + compat::room("nconmax", info);
    case mjWARN_CNSTRFULL: return "the constraint buffer is full: raise " + compat::room("njmax", info);
    case mjWARN_BADQPOS: return "NaN, infinite or huge value in QPOS at " + info + "; the simulation is unstable";
    case mjWARN_BADQVEL: return "NaN, infinite or huge value in QVEL at " + info + "; the simulation is unstable";
    case mjWARN_BADQACC: return "NaN, infinite or huge value in QACC at " + info + "; the simulation is unstable";
    case mjWARN_BADCTRL: return "NaN, infinite or huge value in CTRL at actuator " + info;
    default: return "warning " + std::to_string(kind) + " of MuJoCo";
  }
}

void apply(const PhysicsOptions& options, mjOption& opt) {
  if (options.jacobian == Jacobian::kDense) opt.jacobian = mjJAC_DENSE;
  if (options.jacobian == Jacobian::kSparse) opt.jacobian = mjJAC_SPARSE;
  if (!options.contacts) opt.disableflags |= mjDSBL_CONTACT;
  if (!options.gravity) opt.disableflags |= mjDSBL_GRAVITY;
}

// The accelerations that end a step with these velocities. Those of joints with damping are damped at its end: what
// they had before is M a = (M + h B) (v' - v) / h.
void set_accelerations(const mjModel& model, mjData& data, const double* velocities) {
  const double step = model.opt.timestep;
  for (int i = 0; i < model.nv; ++i) {
    data.qacc[i] = (velocities[i] - data.qvel[i]) / step;
    data.qfrc_inverse[i] = step * model.dof_damping[i] * data.qacc[i];
  }
  mj_solveM(&model, &data, data.qfrc_inverse, data.qfrc_inverse, 1);
  for (int i = 0; i < model.nv; ++i) data.qacc[i] += data.qfrc_inverse[i];
}

std::array<double, 6> velocity_of(const mjModel& model, const mjData& data, int object, int id) {
  std::array<double, 6> spatial{};  // angular, then linear
  mj_objectVelocity(&model, &data, object, id, spatial.data(), 0);
  return {spatial[3], spatial[4], spatial[5], spatial[0], spatial[1], spatial[2]};
}

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

Physics::Physics(ModelPtr model, const PhysicsOptions& options)
    : shared_(std::move(model)), model_(*shared_), overrides_(*shared_), data_(nullptr, nullptr) {
  apply(options, model_.opt);
  const bool own = options.own_solver && solver::newton_step_serves(model_);
  if (own) compat::leave_out_islands(model_.opt);
  step_ = own ? solver::newton_step : mj_step;
  warmstart_.resize(static_cast<std::size_t>(model_.nv));
  positions_.resize(static_cast<std::size_t>(model_.nq));
  start_.assign(model_.qpos0, model_.qpos0 + model_.nq);
  data_ = make_data(model_);  // whose size depends on the options
  reset();
}

void Physics::reset() {
  require_undisturbed();
  failed_ = false;
  run([this] { mj_resetData(&model_, data_.get()); });
  std::copy(start_.begin(), start_.end(), data_->qpos);
  warned_.fill(0);
  run_aside([this] { mj_forward(&model_, data_.get()); });
}

void Physics::step(int count, bool sensors) {
  require_usable();
  require_undisturbed();
  const int flags = model_.opt.disableflags;
  const Scratch scratch(model_, *data_);
  const Complaint complaint = guarded([&] {
    for (int i = 0; i < count && !diverged(*data_); ++i) {
      step_time_ = data_->time;
      model_.opt.disableflags = sensors && i + 1 == count ? flags : flags | mjDSBL_SENSOR;
      const WarningWatch watch(*data_);
      step_(&model_, data_.get());
      watch.count(model_, *data_, counts_);
    }
  });
  model_.opt.disableflags = flags;
  if (complaint.failed) fail_world(complaint.error.data());
  check_divergence();
}

void Physics::follow(const double* positions, double* forces, bool sensors) {
  require_usable();
  require_undisturbed();
  mjData* const data = data_.get();
  const mjModel* const model = &model_;
  velocities_.resize(static_cast<std::size_t>(model_.nv));
  step_time_ = data->time;
  run([&] {
    mj_fwdPosition(model, data);
    if (sensors) mj_sensorPos(model, data);
    mj_fwdVelocity(model, data);
    if (sensors) mj_sensorVel(model, data);
    mj_fwdActuation(model, data);
    mj_differentiatePos(model, velocities_.data(), model->opt.timestep, data->qpos, positions);
    set_accelerations(*model, *data, velocities_.data());
    mj_inverseSkip(model, data, mjSTAGE_VEL, 1);
    compat::expect_accelerations(*data);
    if (sensors) mj_sensorAcc(model, data);
  });
  note_bad(*data_, counts_, mjWARN_BADQPOS, positions, model_.nq);
  note_bad(*data_, counts_, mjWARN_BADQVEL, velocities_.data(), model_.nv);
  note_bad(*data_, counts_, mjWARN_BADQACC, data->qacc, model_.nv);
  check_divergence();
  if (forces != nullptr) std::copy_n(data->qfrc_inverse, model_.nv, forces);
  std::copy_n(positions, model_.nq, data->qpos);
  mj_normalizeQuat(model, data->qpos);
  std::copy_n(velocities_.data(), model_.nv, data->qvel);
  data->time += model_.opt.timestep;
}

void Physics::forward() {
  require_usable();
  require_undisturbed();
  step_time_ = data_->time;
  note_bad(*data_, counts_, mjWARN_BADQPOS, data_->qpos, model_.nq);
  note_bad(*data_, counts_, mjWARN_BADQVEL, data_->qvel, model_.nv);
  check_divergence();
  run_aside([this] { mj_forward(&model_, data_.get()); });
  note_bad(*data_, counts_, mjWARN_BADQACC, data_->qacc, model_.nv);
  check_divergence();
}

void Physics::update_poses() {
  require_usable();
  run_aside([this] {
    mj_kinematics(&model_, data_.get());
    mj_comPos(&model_, data_.get());
    mj_camlight(&model_, data_.get());
  });
}

void Physics::update_contacts() {
  require_usable();
  run_aside([this] {
    mj_kinematics(&model_, data_.get());
    mj_comPos(&model_, data_.get());
    mj_camlight(&model_, data_.get());
    mj_collision(&model_, data_.get());
  });
}

void Physics::place(int body, const double* position, const double* orientation) {
  const int mocap = model_.body_mocapid[body];
  if (position != nullptr) {
    std::copy_n(position, 3, overrides_.position(model_, body));
    if (mocap >= 0) std::copy_n(position, 3, data_->mocap_pos + 3 * mocap);
  }
  if (orientation != nullptr) {
    std::copy_n(orientation, 4, overrides_.orientation(model_, body));
    if (mocap >= 0) std::copy_n(orientation, 4, data_->mocap_quat + 4 * mocap);
  }
}

void Physics::update_poses_at_last_start(Span<const int> turned) {
  require_usable();
  run_aside([this, turned] {
    mj_integratePos(&model_, data_->qpos, data_->qvel, -model_.opt.timestep);
    for (const int address : turned) data_->qpos[address] = positions_[static_cast<std::size_t>(address)];
    mj_kinematics(&model_, data_.get());
    mj_camlight(&model_, data_.get());
  });
}

void Physics::require_undisturbed() const { refuse_callbacks(&model_); }

void Physics::require_usable() const {
  if (failed_) fail(Status::kSimulation, "this world has failed before and needs a reset first");
}

std::vector<Note> Physics::take_warnings() {
  std::vector<Note> notes;
  for (const mjtWarning kind : kSurvivable) {
    const mjWarningStat& stat = data_->warning[kind];
    if (stat.number > 0 && warned_[kind] == 0) notes.push_back({kind_of(kind), text_of(kind, stat)});
    warned_[kind] = stat.number;
  }
  return notes;
}

void Physics::apply_locks() { compat::apply_locks(model_, *data_); }

void Physics::fail_world(const std::string& why) {
  failed_ = true;
  fail(Status::kSimulation, "the simulation failed at {:.4f} s: {}", step_time_, why);
}

void Physics::check_divergence() {
  for (const mjtWarning kind : kDivergence) {
    if (data_->warning[kind].number > 0) fail_world(text_of(kind, data_->warning[kind]));
  }
}

// The solver starts from the last acceleration, and kinematics normalises the quaternions among the positions, which is
// not the same when done twice: putting both back is what keeps the trajectory to the bit.
template <typename Call>
void Physics::run_aside(Call&& call) {
  step_time_ = data_->time;
  std::copy_n(data_->qpos, model_.nq, positions_.data());
  std::copy_n(data_->qacc_warmstart, model_.nv, warmstart_.data());
  run(call);
  std::copy_n(positions_.data(), model_.nq, data_->qpos);
  std::copy_n(warmstart_.data(), model_.nv, data_->qacc_warmstart);
}

std::array<double, 6> contact_force(const mjModel& model, const mjData& data, int contact) {
  std::array<double, 6> force{};
  mj_contactForce(&model, &data, contact, force.data());
  return force;
}

std::array<double, 6> body_velocity(const mjModel& model, const mjData& data, int body) {
  return velocity_of(model, data, mjOBJ_XBODY, body);
}

std::array<double, 6> site_velocity(const mjModel& model, const mjData& data, int site) {
  return velocity_of(model, data, mjOBJ_SITE, site);
}

std::array<double, 4> quaternion(const double* matrix) {
  std::array<double, 4> quat{};
  mju_mat2Quat(quat.data(), matrix);
  return quat;
}

const char* mujoco_version() { return mj_versionString(); }

// Physics::save and load.

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
