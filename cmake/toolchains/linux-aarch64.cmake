# Linux on 64-bit ARM with glibc 2.17 (of 2012) or newer. Here programs run under qemu, with the C library of Debian's
# package libc6-arm64-cross.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(MIMO_ZIG_TARGET aarch64-linux-gnu.2.17)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu)
include(${CMAKE_CURRENT_LIST_DIR}/zig.cmake)
