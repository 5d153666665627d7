# How everything in this repository is compiled.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()

set(CMAKE_C_STANDARD 99)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT EMSCRIPTEN)  # a module is linked once and for all
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  include(CheckPIESupported)
  check_pie_supported()  # tells the linker so of programs, too
endif()
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/lib)

# Numbers must not depend on which multiplications a compiler happens to fuse.
add_compile_options(-ffp-contract=off)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include \"${PROJECT_SOURCE_DIR}/cmake/unfused_arm.h\">")
elseif(EMSCRIPTEN)
  # Eigen knows no vectors of WebAssembly, and without vectors it adds in another order than on x86-64. Emscripten
  # translates SSE2. Eigen then also includes the compiler's own header for MMX, which is for x86 only and empty under
  # this name, and writes assembly for versions of GCC before 6.3, such as the 4.2 that Clang calls itself.
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-msse2 -D__MMINTRIN_H -fgnuc-version=4.23>")
  # Clang 14 for WebAssembly packs scalars into wrong vectors: growth/mechanics.cpp without SSE2 gave other inertias with
  # -O3 than with -O0 or with this.
  add_compile_options(-fno-slp-vectorize)
endif()

set(mimo_warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(EMSCRIPTEN)  # numbers of 64 bits that count something here; what files say of sizes is compared before it is cut
  list(APPEND mimo_warnings -Wno-shorten-64-to-32)
endif()
if(MIMO_WERROR)
  list(APPEND mimo_warnings -Werror)
endif()
add_compile_options("$<$<COMPILE_LANGUAGE:C,CXX>:${mimo_warnings}>")

if(MIMO_SANITIZE)
  add_compile_options($<$<COMPILE_LANGUAGE:C,CXX>:-fsanitize=${MIMO_SANITIZE}>
                      $<$<COMPILE_LANGUAGE:C,CXX>:-fno-sanitize-recover=all>
                      $<$<COMPILE_LANGUAGE:C,CXX>:-fno-omit-frame-pointer>)
  add_link_options(-fsanitize=${MIMO_SANITIZE})
elseif(CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
  # A symbol that nobody defines is an error here, not at a user's dlopen. (Sanitizers resolve theirs at load; the
  # linkers of other systems refuse by themselves.)
  string(APPEND CMAKE_SHARED_LINKER_FLAGS " -Wl,-z,defs")
endif()

if(MIMO_FUZZ)
  # Coverage for libFuzzer, without its main.
  add_compile_options($<$<COMPILE_LANGUAGE:C,CXX>:-fsanitize=fuzzer-no-link>)
  add_link_options(-fsanitize=fuzzer-no-link)
endif()

# ccache keeps what was compiled with precompiled headers, and finds it again in a clone in another folder: paths below
# the sources are taken as relative, and the folder that a compiler runs in does not count.
find_program(MIMO_CCACHE ccache)
if(MIMO_CCACHE)
  set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=1
               "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}")
  if(EMSCRIPTEN)  # a program around its compiler, which calls it itself
    list(APPEND launcher EM_COMPILER_WRAPPER=${MIMO_CCACHE})
  else()
    list(APPEND launcher ${MIMO_CCACHE})
  endif()
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()
