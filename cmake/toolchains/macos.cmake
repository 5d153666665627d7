# macOS 11 and newer, on Apple silicon. Built, never run.
set(MIMO_SYSTEM macos)
set(CMAKE_SYSTEM_NAME Darwin)
set(CMAKE_SYSTEM_PROCESSOR arm64)
set(CMAKE_OSX_SYSROOT "" CACHE STRING "")  # zig brings what it needs
set(CMAKE_OSX_DEPLOYMENT_TARGET "" CACHE STRING "")  # in the name of its target
set(CMAKE_INSTALL_NAME_TOOL true)
include(${CMAKE_CURRENT_LIST_DIR}/zig.cmake)
