// What is to happen around fork(), on systems that have it.
#pragma once

namespace mimo {

// Registers functions for the length of the library's life, as pthread_atfork does; each may be null.
int watch_forks(void (*before)(), void (*in_parent)(), void (*in_child)());

}  // namespace mimo
