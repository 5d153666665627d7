#pragma once

#include "tasks/task.h"

namespace mimo::tasks {

extern const Definition kRollover;

}  // namespace mimo::tasks
