#include "base/fork.h"

namespace mimo {

// Windows has no fork().
int watch_forks(void (*)(), void (*)(), void (*)()) { return 0; }

}  // namespace mimo
