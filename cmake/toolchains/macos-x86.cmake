# macOS 11 and newer, on x86-64. Never run.
set(MIMO_SYSTEM macos-x86)
set(CMAKE_SYSTEM_NAME Darwin)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
include(${CMAKE_CURRENT_LIST_DIR}/zig.cmake)
