#include <pthread.h>

#include "base/fork.h"

namespace mimo {

int watch_forks(void (*before)(), void (*in_parent)(), void (*in_child)()) {
  return pthread_atfork(before, in_parent, in_child);
}

}  // namespace mimo
