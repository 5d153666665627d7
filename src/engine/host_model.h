// A model and data of the host's own simulation, handed over as bare pointers.
#pragma once

#include <cstddef>

#include "engine/model.h"

typedef struct mjData_ mjData;

namespace mimo::engine {

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
