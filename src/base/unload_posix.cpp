#include "base/unload.h"

namespace mimo {
namespace {

bool unloading = false;

#ifdef __ELF__
// When a library is unloaded, functions like this one run before the destructors of static objects: those are called by
// the first entry of the list that this function stands in, and the list is run backwards. When the process ends,
// exit() destroys static objects first and runs the lists of libraries afterwards.
__attribute__((destructor)) void begin() { unloading = true; }
#endif

}  // namespace

bool is_unloading() { return unloading; }

}  // namespace mimo
