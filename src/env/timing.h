// Where a step's time goes.
#pragma once

#include <cstdint>

#include "observation/observer.h"

namespace mimo::env {

struct Timing {
  std::uint64_t steps = 0;
  double total = 0;
  double physics = 0;
  observation::ShareTimes senses{};
};

}  // namespace mimo::env
