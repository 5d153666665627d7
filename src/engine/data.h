// A world's mjData, and the model and data of a host's own simulation.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <cstddef>
#include <memory>

#include "engine/model.h"

namespace mimo::engine {

// A world's mjData.

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

typedef struct mjData_ mjData;

namespace mimo::engine {

// A model and data of the host's own simulation, handed over as bare pointers.

// What the host's MuJoCo says about itself; sizes of 0 where the host cannot know them.
struct HostModel {
  const void* model = nullptr;
  int version = 0;  // mj_version()
  std::size_t model_size = 0, data_size = 0;
};

// The model, which stays the host's. Throws Status::kUnsupported for another MuJoCo than ours, kInvalidArgument for
// what cannot be a model of it.
ModelPtr adopt(const HostModel& host);

// Data of that model. Throws Status::kInvalidArgument for what cannot be.
const mjData& adopt_data(const mjModel& model, const void* data);

}  // namespace mimo::engine
