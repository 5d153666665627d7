# Makes the next minor version of the interface out of today's: every struct has one member more, there is a bit, a
# quantity and a function more, and the function has a symbol node of its own.
#   cmake -DSOURCE=<repository> -DOUT=<folder> -P GrownStep.cmake
file(GLOB_RECURSE headers RELATIVE ${SOURCE}/include ${SOURCE}/include/mimo/*)
foreach(header IN LISTS headers)
  file(READ ${SOURCE}/include/${header} text)
  string(REGEX REPLACE "\n} (mimo_[a-z_]+);" "\n  uint64_t grown;\n} \\1;" text "${text}")
  if(header STREQUAL "mimo/status.h")
    string(REGEX MATCH "#define MIMO_API_MINOR ([0-9]+)" line "${text}")
    math(EXPR minor "${CMAKE_MATCH_1} + 1")
    string(REPLACE "${line}" "#define MIMO_API_MINOR ${minor}" text "${text}")
    string(REGEX MATCH "#define MIMO_API_MAJOR ([0-9]+)" line "${text}")
    set(major ${CMAKE_MATCH_1})
    string(APPEND text "#define MIMO_RENDER_GROWN 0x40000000u\n#define MIMO_WORLD_GROWN 10000\n"
                       "#ifdef __cplusplus\nextern \"C\" {\n#endif\n"
                       "MIMO_API int32_t mimo_grown(void) MIMO_NOEXCEPT;\n#ifdef __cplusplus\n}\n#endif\n")
  endif()
  file(WRITE ${OUT}/include/${header} "${text}")
endforeach()

file(READ ${SOURCE}/src/capi/exports.map map)
string(REGEX MATCHALL "\nMIMO_[0-9.]+ {" nodes "${map}")
list(GET nodes -1 last)
string(REGEX MATCH "MIMO_[0-9.]+" last "${last}")
file(WRITE ${OUT}/exports.map "${map}\nMIMO_${major}.${minor} {\n  global:\n    mimo_grown;\n} ${last};\n")

file(WRITE ${OUT}/grown.cpp "#include \"mimo/mimo.h\"\n\nint32_t mimo_grown(void) noexcept { return 77; }\n")
