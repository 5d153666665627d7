# Compilers of the Python package ziglang for MIMO_ZIG_TARGET, a name that zig knows. It brings libc++ and the C libraries
# of all systems in all their versions: the first one of a name like x86_64-linux-gnu.2.17 is what runs it.
set(MIMO_ZIG ${CMAKE_CURRENT_LIST_DIR}/../../build/cross/zig CACHE FILEPATH "The program zig")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MIMO_ZIG MIMO_ZIG_TARGET)

# CMake and ccache want programs, where zig has commands.
set(mimo_zig_tools ${CMAKE_BINARY_DIR}/zig-tools)
foreach(tool cc c++ ar ranlib)
  set(line "exec '${MIMO_ZIG}' ${tool}")
  if(tool MATCHES "^c")
    string(APPEND line " -target ${MIMO_ZIG_TARGET}")
  endif()
  if(NOT EXISTS ${mimo_zig_tools}/${tool})
    file(WRITE ${mimo_zig_tools}/${tool} "#!/bin/sh\n${line} \"$@\"\n")
    file(CHMOD ${mimo_zig_tools}/${tool} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  endif()
endforeach()
set(CMAKE_C_COMPILER ${mimo_zig_tools}/cc)
set(CMAKE_CXX_COMPILER ${mimo_zig_tools}/c++)
set(CMAKE_ASM_COMPILER ${mimo_zig_tools}/cc)
set(CMAKE_AR ${mimo_zig_tools}/ar)
set(CMAKE_RANLIB ${mimo_zig_tools}/ranlib)

# zig watches undefined behaviour unless told otherwise, and its debug information would make up most of a library.
set(CMAKE_C_FLAGS_INIT "-fno-sanitize=undefined -g0")
set(CMAKE_CXX_FLAGS_INIT "-fno-sanitize=undefined -g0")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
