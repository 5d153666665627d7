#pragma once

#include "tasks/task.h"

namespace mimo::tasks {

extern const Definition kSelfbody;

}  // namespace mimo::tasks
