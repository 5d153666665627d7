# Any Linux with glibc 2.28 or newer, on 64-bit ARM; its programs run here by QEMU.
set(MIMO_SYSTEM arm)
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
# A host's exceptions come through the library, so they share what unwinds the stack: GCC's, not zig's own.
set(MIMO_UNWINDER /usr/aarch64-linux-gnu/lib/libgcc_s.so.1)
include(${CMAKE_CURRENT_LIST_DIR}/zig.cmake)
