#pragma once

#include "tasks/task.h"

namespace mimo::tasks {

extern const Definition kStandup;

}  // namespace mimo::tasks
