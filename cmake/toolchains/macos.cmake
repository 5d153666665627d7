# macOS 11 and newer, on Apple silicon. Never run.
set(MIMO_SYSTEM macos)
set(CMAKE_SYSTEM_NAME Darwin)
set(CMAKE_SYSTEM_PROCESSOR arm64)
include(${CMAKE_CURRENT_LIST_DIR}/zig.cmake)
