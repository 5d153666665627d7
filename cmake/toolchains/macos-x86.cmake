# macOS 11 and newer, on x86-64. Built, never run.
set(MIMO_SYSTEM macos-x86)
set(CMAKE_SYSTEM_NAME Darwin)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_OSX_SYSROOT "" CACHE STRING "")  # zig brings what it needs
set(CMAKE_OSX_DEPLOYMENT_TARGET "" CACHE STRING "")  # in the name of its target
set(CMAKE_INSTALL_NAME_TOOL true)
include(${CMAKE_CURRENT_LIST_DIR}/zig.cmake)
