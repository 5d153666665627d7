#pragma once

#include "tasks/task.h"

namespace mimo::tasks {

extern const Definition kReach;

}  // namespace mimo::tasks
