// A world's mjData.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <cstddef>
#include <memory>

namespace mimo::engine {

using DataPtr = std::unique_ptr<mjData, void (*)(mjData*)>;

// As mj_makeData makes it, but without room that no step of this model can fill, and without touching what a step need
// not: MuJoCo 2.2 sizes the constraints' matrices as if all were full, which is most of the 200 MB that ten infants in
// one scene took. `model` and its solver and Jacobian stay what they are. Only MuJoCo's functions that know no other
// layout (mj_copyData) do not take it, nor does a MuJoCo that is compiled with ADDRESS_SANITIZER defined: its
// mj_resetData clears each array at the size that is listed. Throws Status::kOutOfMemory.
DataPtr make_data(const mjModel& model);

// The place of the first number that MuJoCo takes for a divergence (none, infinite or huge), -1 where there is none.
int first_bad(const double* values, int count);

// How many numbers the constraints' Jacobian can have, all rows together.
std::size_t jacobian_room(const mjModel& model);

}  // namespace mimo::engine
