// Catching: see catch.cpp.
#pragma once

#include "tasks/task.h"

namespace mimo::tasks {

extern const Definition kCatch;

}  // namespace mimo::tasks
