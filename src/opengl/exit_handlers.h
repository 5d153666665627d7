// Mesa ends its threads by a function that exit() calls. In a forked child these threads do not exist, and it crashes
// or waits for ever.
#pragma once

namespace mimo::opengl {

// What the library that holds the address `inside` registers from now on for the end of the process is run in the
// process that registered it, and not in its children. As far as the dynamic linker's tables can be read.
void keep_exit_handlers_from_children(const void* inside);

}  // namespace mimo::opengl
