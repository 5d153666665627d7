# WebAssembly, for browsers and Node, by Debian's Emscripten: 32 bits, vectors, the exceptions of WebAssembly itself.
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
set(EMSCRIPTEN_SYSTEM_PROCESSOR wasm32)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_C_FLAGS_INIT "-msimd128 -fwasm-exceptions -sSUPPORT_LONGJMP=wasm")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=2097152")
