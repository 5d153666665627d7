// One world's physics: its state, stepped under the guard.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/span.h"
#include "engine/guard.h"
#include "engine/hooks.h"
#include "engine/model.h"
#include "engine/overrides.h"
#include "engine/scratch.h"
#include "mimo/experimental/engine.h"

namespace mimo::engine {

// Of the header.
enum class Jacobian : std::int32_t {
  kModel = MIMO_JACOBIAN_MODEL,
  kDense = MIMO_JACOBIAN_DENSE,
  kSparse = MIMO_JACOBIAN_SPARSE,
};

struct PhysicsOptions {
  Jacobian jacobian = Jacobian::kModel;
  bool contacts = true;
  bool gravity = true;
  bool own_solver = true;  // where the model allows
};

class Physics {
 public:
  // At first everything is at qpos0.
  Physics(ModelPtr model, const PhysicsOptions& options);

  // The world's own view of the model: a copy of the struct, arrays shared with all other worlds.
  const mjModel& model() const { return model_; }
  mjData& data() { return *data_; }
  const mjData& data() const { return *data_; }

  // Where resets lead to: positions of all joints, qpos0 unless set.
  Span<double> start() { return start_; }
  // Back to the start at rest, nothing applied; makes a failed world usable again.
  void reset();

  // Physics steps. Throws Status::kSimulation when MuJoCo gives up or the state diverges; the world is then failed.
  // Sensors are worth a few percent of a step: they are those of the last step, or stay as they are without `sensors`.
  void step(int count, bool sensors = true);

  // A physics step in which joints go where they are told, by inverse dynamics: all that a step computes is that of its
  // start, with the accelerations that lead there. `forces` receives what else than contacts, limits, springs and
  // dampers had to act on each degree of freedom; it may be null.
  void follow(const double* positions, double* forces, bool sensors);

  // Recomputes everything that follows from the state, without changing the trajectory.
  void forward();

  // Recomputes poses only (bodies, geoms, sites, cameras, lights).
  void update_poses();
  // The same, and contacts.
  void update_contacts();
  // Poses, but as of the start of the last physics step, to which everything else that a step computed belongs. For
  // a task that has turned joints since (`turned` holds their addresses in qpos): these are where they are now.
  void update_poses_at_last_start(Span<const int> turned);

  // Differences from the shared model, for this world only. They outlive resets.
  void hold(int lock, double angle) {
    overrides_.hold(model_, lock, angle);
    apply_locks();
  }
  void release(int lock) {
    overrides_.release(model_, lock);
    apply_locks();
  }
  void release(int lock, double angle) {
    overrides_.release(model_, lock, angle);
    apply_locks();
  }
  double& gear(int actuator) { return overrides_.gear(model_, actuator); }
  void paint(int geom, int material) { overrides_.paint(model_, geom, material); }
  void slacken(int joint, int dof, double damping) { overrides_.slacken(model_, joint, dof, damping); }
  void unlimit(int actuator) { overrides_.unlimit(model_, actuator); }
  void shape_ball(int body, double radius, double mass) { overrides_.shape_ball(model_, body, radius, mass); }
  void set_masses(Span<const std::int32_t> bodies, Span<const double> masses) {
    overrides_.set_masses(model_, bodies, masses);
  }
  void resize(int geom, const double* size) { overrides_.resize(model_, geom, size); }
  void damp(int joint, double damping) { overrides_.damp(model_, joint, damping); }
  double* friction(int geom) { return overrides_.friction(model_, geom); }
  float* color(int geom) { return overrides_.color(model_, geom); }
  double* light_position(int light) { return overrides_.light_position(model_, light); }
  double* light_direction(int light) { return overrides_.light_direction(model_, light); }
  float* light_color(int light) { return overrides_.light_color(model_, light); }
  // Of a body that stands fixed on the world.
  void place(int body, const double* position, const double* orientation);
  Eigen::Vector3d gravity() const { return Eigen::Map<const Eigen::Vector3d>(model_.opt.gravity); }  // m/s^2
  void set_gravity(const Eigen::Vector3d& gravity) { Eigen::Map<Eigen::Vector3d>{model_.opt.gravity} = gravity; }

  // Throws Status::kUnsupported when callbacks of the host would act on this world (engine/callbacks.h).
  void require_undisturbed() const;

  bool failed() const { return failed_; }
  // Throws Status::kSimulation when the world has failed and has not been reset.
  void require_usable() const;

  // The numbers from which the trajectory continues to the bit: how this world differs from the shared model; and
  // state, controls, applied forces, the solver's start. Checks throw Status::kInvalidArgument for what save never
  // writes, with nothing changed; a load comes after its check. After both loads poses and body velocities are those of
  // the new state; contacts, sensors and accelerations are empty until the next step or forward(). Makes a failed world
  // usable again.
  void save_overrides(ByteWriter& to) const { Overrides::save(model_, to); }
  void check_overrides(ByteReader& from) const { Overrides::check(model_, from); }
  void load_overrides(ByteReader& from) {
    overrides_.load(model_, from);
    apply_locks();
  }
  void save(ByteWriter& to) const;
  void check(ByteReader& from) const;
  void load(ByteReader& from);

  // Warnings that are not failures (contact or constraint buffers full, ...) since the last call, each once an episode.
  std::vector<Note> take_warnings();
  // Takes over what outlives a change of the model: gravity, and the counts of warnings.
  void succeed(const Physics& before) {
    set_gravity(before.gravity());
    counts_ = before.counts_;
  }
  // How often each happened in a physics step, since this was made; and failures.
  const WarningCounts& warnings() const { return counts_; }
  void forget_warnings(int kind) { counts_[static_cast<std::size_t>(kind)] = 0; }

 private:
  void apply_locks();  // where MuJoCo keeps with the state which ones hold
  void fail_world(const std::string& why);
  void check_divergence();
  void forget_derived();
  // Calls MuJoCo under the guard; the world is failed when it gives up.
  template <typename Call>
  void run(Call&& call) {
    const Scratch scratch(model_, *data_);
    const Complaint complaint = guarded(call);
    if (complaint.failed) fail_world(complaint.error.data());
  }
  template <typename Call>
  void run_aside(Call&& call);  // leaves the trajectory as it was

  ModelPtr shared_;
  mjModel model_;
  Overrides overrides_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  std::vector<double> start_;
  std::array<int, mjNWARNING> warned_{};
  WarningCounts counts_{};
  std::vector<double> positions_, warmstart_;  // room to keep what a look at the world changes
  std::vector<double> velocities_;             // room for those at the end of a step that follows
  double step_time_ = 0;  // when the step in progress started; MuJoCo sets a diverged world's time back
  void (*step_)(const mjModel*, mjData*);  // mj_step, or the same with our own solver
  bool failed_ = false;
};

// Force and torque of a contact in its frame, acting on the body of geom 2: {fn, ft1, ft2, tn, tt1, tt2}.
std::array<double, 6> contact_force(const mjModel& model, const mjData& data, int contact);

// Velocity of a body's origin in the world frame: linear, then angular.
std::array<double, 6> body_velocity(const mjModel& model, const mjData& data, int body);
std::array<double, 6> site_velocity(const mjModel& model, const mjData& data, int site);

// w x y z of a rotation matrix (row-major).
std::array<double, 4> quaternion(const double* matrix);

// MuJoCo's version as "2.2.2".
const char* mujoco_version();

}  // namespace mimo::engine
