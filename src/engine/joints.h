// What kinds of joints there are in a compiled model.
#pragma once

#include "engine/model.h"

namespace mimo::engine {

// A hinge or a slide, whose position is one number.
bool has_one_axis(const mjModel& model, int joint);

// How many numbers a joint of this type (mjJNT_...) has for its position, and for its velocity.
int position_count(int joint_type);
int velocity_count(int joint_type);

// Where the quaternion starts among the numbers of its position; -1 if it has none.
int quaternion_place(int joint_type);

// Where the position of a body with a free joint starts in qpos. Throws Status::kModel for a body without.
int free_joint_address(const mjModel& model, int body);

// Makes a quaternion one of length 1, as MuJoCo does.
void normalize_quaternion(double* quaternion);

}  // namespace mimo::engine
