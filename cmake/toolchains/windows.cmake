# Windows on x86-64, by Debian's mingw-w64 with POSIX threads.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)  # MuJoCo's lie elsewhere
set(CMAKE_CROSSCOMPILING_EMULATOR /usr/lib/wine/wine64)  # Debian's package wine64 puts it nowhere else

# What Windows does not bring is inside: users have no mingw. No file says when it was linked.
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static -s -Wl,--no-insert-timestamp")
set(CMAKE_MODULE_LINKER_FLAGS_INIT "-static -s -Wl,--no-insert-timestamp")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -s -Wl,--no-insert-timestamp")

# Windows aligns stacks to 16 bytes, GCC believes that rows of 32 and more are aligned there (its bug 54412) and moves
# them by instructions that fault where they are not. The assembler writes the others.
set(CMAKE_CXX_FLAGS_INIT -Wa,-muse-unaligned-vector-move)
