# zig's compiler, which ./dev puts into build/cross/zig/SYSTEM. The toolchains of the systems include this.
set(zig_tools ${CMAKE_CURRENT_LIST_DIR}/../../build/cross/zig/${MIMO_SYSTEM})
set(CMAKE_C_COMPILER ${zig_tools}/cc)
set(CMAKE_CXX_COMPILER ${zig_tools}/c++)
set(CMAKE_AR ${zig_tools}/ar CACHE FILEPATH "")
set(CMAKE_RANLIB ${zig_tools}/ranlib CACHE FILEPATH "")
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH ${zig_tools})  # nothing of this machine's
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-s ${MIMO_UNWINDER}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-s ${MIMO_UNWINDER}")

# Debian's compiler does this by default.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(CMAKE_C_FLAGS_INIT "-fstack-protector-strong -D_FORTIFY_SOURCE=2")
  set(CMAKE_CXX_FLAGS_INIT "-fstack-protector-strong -D_FORTIFY_SOURCE=2")
endif()

if(CMAKE_SYSTEM_NAME STREQUAL "Darwin")
  set(CMAKE_OSX_SYSROOT "" CACHE STRING "")  # zig brings what it needs
  set(CMAKE_OSX_DEPLOYMENT_TARGET "" CACHE STRING "")  # in the name of its target
  set(CMAKE_INSTALL_NAME_TOOL true)
endif()
