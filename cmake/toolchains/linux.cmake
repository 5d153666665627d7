# Any Linux with glibc 2.28 or newer, on x86-64.
set(MIMO_SYSTEM linux)
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
# A host's exceptions come through the library, so they share what unwinds the stack: GCC's, not zig's own.
set(MIMO_UNWINDER /lib/x86_64-linux-gnu/libgcc_s.so.1)
include(${CMAKE_CURRENT_LIST_DIR}/zig.cmake)
