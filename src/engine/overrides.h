// How one world's model differs from the model that it shares with others, and what MuJoCo derives from changed masses.
#pragma once

#include <mujoco/mjmodel.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "base/bytes.h"
#include "base/span.h"

namespace mimo::engine {

// What MuJoCo's compiler derives from the masses of bodies, found out anew for masses that one world has changed.

// A model like the given one whose masses can be tried out: its numbers are its own, what is only drawn stays shared.
// MuJoCo writes to more than masses when it derives, and none of that may reach a model that worlds share.
class Constants {
 public:
  explicit Constants(const mjModel& model);

  // The inertia grows along.
  void scale_mass(int body, double mass);
  // Throws Status::kInvalidArgument for masses with which there is no calculating.
  void derive();
  // Copies masses and what follows from them to a model whose arrays may be written to.
  void copy_to(mjModel& model) const;

 private:
  mjModel model_;
  std::vector<std::unique_ptr<std::uint8_t[]>> arrays_;
};

// How one world's model differs from the model that it shares with others: locked joints, gears, faces, masses, sizes,
// colours, ... The first change of an array copies it; everything else stays shared. (Gravity lies in the struct
// itself, which every world has for its own.)

class Overrides {
 public:
  // `shared` outlives this, and every model given here is a copy of its struct.
  explicit Overrides(const mjModel& shared) : shared_(shared) {}

  // Holds a joint at an angle by its lock, an equality of one joint; `lock` is as find_lock gives it.
  void hold(mjModel& model, int lock, double angle);
  // Lets it go. The angle is where it would hold the joint.
  void release(mjModel& model, int lock, double angle);
  void release(mjModel& model, int lock);
  void paint(mjModel& model, int geom, int material);
  // Size (m) and mass (kg) of a ball, with everything that follows from them.
  void shape_ball(mjModel& model, int body, double radius, double mass);
  // Masses (kg, above 0) of bodies that have one; their inertias grow along, and everything that MuJoCo's compiler
  // derives from both follows, except the statistic of mean inertia. Throws Status::kInvalidArgument, with nothing
  // changed, for masses with which it cannot calculate.
  void set_masses(mjModel& model, Span<const std::int32_t> bodies, Span<const double> masses);
  // Size of a geom that has a size_count, and the sphere around it; others stay. So does its body's mass.
  void resize(mjModel& model, int geom, const double* size);
  void damp(mjModel& model, int joint, double damping);
  // Takes a hinge's spring away and sets its damper. Frees a motor from its limits. Neither is part of a state: a world
  // does it when it is made.
  void slacken(mjModel& model, int joint, int dof, double damping);
  void unlimit(mjModel& model, int actuator);

  // What has no consequences beyond itself, to be written to.
  double& gear(mjModel& model, int actuator);
  double* friction(mjModel& model, int geom);          // 3
  float* color(mjModel& model, int geom);              // red, green, blue, opacity
  double* light_position(mjModel& model, int light);   // 3, as its body lies
  double* light_direction(mjModel& model, int light);  // 3
  float* light_color(mjModel& model, int light);       // 3
  double* position(mjModel& model, int body);          // 3, as its parent lies
  double* orientation(mjModel& model, int body);       // 4

  // Everything in which a world's model may differ, gravity included.
  static void save(const mjModel& model, ByteWriter& to);
  // Reads past it. Throws Status::kInvalidArgument for what save never writes.
  static void check(const mjModel& model, ByteReader& from);
  void load(mjModel& model, ByteReader& from);  // after check

 private:
  // Gives the model an array of its own in place of the shared one, unless it has one, and returns it.
  template <typename T>
  T* own(mjModel& model, T* mjModel::*array, int length);
  void own_locks(mjModel& model);
  void own_masses(mjModel& model);
  void own_bounds(mjModel& model, int geom);

  const mjModel& shared_;
  std::vector<std::unique_ptr<std::uint8_t[]>> arrays_;
};

// Whether a body is a single flying ball: a free joint, and nothing but one sphere.
bool is_ball(const mjModel& model, int body);

// How many numbers say how large a geom is; 0 for planes and for those that have their shape from a file.
int size_count(int geom_type);

// The equality that can hold a joint; -1 if the model has none.
int find_lock(const mjModel& model, int joint);

// Whether a lock holds its joint.
bool is_held(const mjModel& model, int lock);

// The angle at which a lock holds, or would hold, its joint.
double lock_angle(const mjModel& model, int lock);

}  // namespace mimo::engine
