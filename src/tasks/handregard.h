// Hand regard, as in BabyBench.
#pragma once

#include "tasks/task.h"

namespace mimo::tasks {

extern const Definition kHandregard;

}  // namespace mimo::tasks
