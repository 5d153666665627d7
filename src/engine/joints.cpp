#include "engine/joints.h"

#include <mujoco/mujoco.h>

#include "base/fail.h"

namespace mimo::engine {

bool has_one_axis(const mjModel& model, int joint) {
  return model.jnt_type[joint] == mjJNT_HINGE || model.jnt_type[joint] == mjJNT_SLIDE;
}

int position_count(int joint_type) { return joint_type == mjJNT_FREE ? 7 : joint_type == mjJNT_BALL ? 4 : 1; }

int velocity_count(int joint_type) { return joint_type == mjJNT_FREE ? 6 : joint_type == mjJNT_BALL ? 3 : 1; }

int quaternion_place(int joint_type) { return joint_type == mjJNT_FREE ? 3 : joint_type == mjJNT_BALL ? 0 : -1; }

int free_joint_address(const mjModel& model, int body) {
  const int joint = model.body_jntadr[body];
  if (joint < 0 || model.jnt_type[joint] != mjJNT_FREE) {
    fail(Status::kModel, "body {} has no free joint", name(model, Kind::kBody, body));
  }
  return model.jnt_qposadr[joint];
}

void normalize_quaternion(double* quaternion) { mju_normalize4(quaternion); }

}  // namespace mimo::engine
