// How one world's model differs from the model that it shares with others: locked joints, gears, faces, balls. The
// first change of a kind copies the arrays it concerns; everything else stays shared. (Gravity lies in the struct
// itself, which every world has for its own.)
#pragma once

#include <mujoco/mjmodel.h>

#include <vector>

#include "base/bytes.h"

namespace mimo::engine {

class Overrides {
 public:
  // Makes room for changes of a kind, so that making them allocates nothing.
  void own_locks(mjModel& model);
  void own_gears(mjModel& model);
  void own_materials(mjModel& model);

  // Holds a joint at an angle by its lock, an equality of one joint; `lock` is as find_lock gives it.
  void hold(mjModel& model, int lock, double angle);
  void release(mjModel& model, int lock);
  double& gear(mjModel& model, int actuator);
  void paint(mjModel& model, int geom, int material);
  // Size (m) and mass (kg) of a ball, with everything that follows from them.
  void shape_ball(mjModel& model, int body, double radius, double mass);
  // Takes a hinge's spring away and sets its damper. Frees a motor from its limits. Neither is part of a state: a world
  // does it when it is made.
  void slacken(mjModel& model, int joint, int dof, double damping);
  void unlimit(mjModel& model, int actuator);

  // Everything in which a world's model may differ, gravity included.
  static void save(const mjModel& model, ByteWriter& to);
  // Reads past it. Throws Status::kInvalidArgument for what save never writes.
  static void check(const mjModel& model, ByteReader& from);
  void load(mjModel& model, ByteReader& from);  // after check

 private:
  std::vector<mjtByte> active_;
  std::vector<mjtNum> data_;
  std::vector<mjtNum> gear_;
  void own_balls(mjModel& model);

  std::vector<int> material_;
  std::vector<mjtNum> size_, bound_, mass_, subtree_mass_, inertia_, body_weight_, dof_weight_, dof_inertia_;
  std::vector<mjtNum> stiffness_, damping_;
  std::vector<mjtByte> control_limited_, force_limited_;
};

// Whether a body is a ball that flies by itself: a free joint, and nothing but one sphere.
bool is_ball(const mjModel& model, int body);

// The equality that can hold a joint; -1 if the model has none.
int find_lock(const mjModel& model, int joint);

// The angle at which a lock holds, or would hold, its joint.
double lock_angle(const mjModel& model, int lock);

}  // namespace mimo::engine
