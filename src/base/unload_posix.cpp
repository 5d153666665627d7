#include <atomic>
#include <cstdlib>

#include "base/unload.h"

namespace mimo {
namespace {

bool unloading = false, ending = false;
std::atomic_flag watched = ATOMIC_FLAG_INIT;

#ifdef __ELF__
// When a library is unloaded, functions like this one run before the destructors of static objects, and before what was
// given to atexit(): those are called by the first entry of the list that this function stands in, and the list is run
// backwards. When the process ends, exit() calls first what came last. The lists of libraries that the program is
// linked with come after what the program's run gave to atexit(), and before the destructors of their static objects.
__attribute__((destructor)) void begin() { unloading = true; }
#endif

}  // namespace

bool is_unloading() { return unloading && !ending; }

void watch_the_end() {
  if (!watched.test_and_set()) std::atexit([] { ending = !unloading; });
}

}  // namespace mimo
