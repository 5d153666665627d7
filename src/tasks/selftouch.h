// Self-touch, as in BabyBench.
#pragma once

#include "tasks/task.h"

namespace mimo::tasks {

extern const Definition kSelftouch;

}  // namespace mimo::tasks
