// How one world's model differs from the model that it shares with others: locked joints, gears, faces. The first
// change of a kind copies the arrays it concerns; everything else stays shared. (Gravity lies in the struct itself,
// which every world has for its own.)
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

  // Everything in which a world's model may differ, gravity included.
  static void save(const mjModel& model, ByteWriter& to);
  // Reads past it. Throws Status::kInvalidArgument for what save never writes.
  static void check(const mjModel& model, ByteReader& from);
  void load(mjModel& model, ByteReader& from);  // after check

 private:
  std::vector<mjtByte> active_;
  std::vector<mjtNum> data_;
  std::vector<mjtNum> gear_;
  std::vector<int> material_;
};

// The equality that can hold a joint; -1 if the model has none.
int find_lock(const mjModel& model, int joint);

// The angle at which a lock holds, or would hold, its joint.
double lock_angle(const mjModel& model, int lock);

}  // namespace mimo::engine
