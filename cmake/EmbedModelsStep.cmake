# Build step of EmbedModels.cmake: writes resources.cpp and, with METHOD=incbin, resources.S into OUT,
# out of the files of FOLDER that LIST names. Sizes are looked up here, at build time, so they are never stale.
file(STRINGS ${LIST} files)

# Symbols start with "resource_", not "mimo_": everything called mimo_* would be exported.
set(assembly "  .section .rodata\n")
set(declarations "")
set(table "")
set(count 0)
foreach(file IN LISTS files)
  set(symbol resource_${count})
  file(SIZE ${FOLDER}/${file} size)
  if(METHOD STREQUAL "incbin")
    # One zero byte follows each file: texts may be read as C strings.
    string(APPEND assembly "  .balign 16\n  .globl ${symbol}\n  .hidden ${symbol}\n${symbol}:\n"
                           "  .incbin \"${FOLDER}/${file}\"\n  .byte 0\n")
    string(APPEND declarations "extern \"C\" const unsigned char ${symbol}[];\n")
  else()
    file(READ ${FOLDER}/${file} bytes HEX)
    string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(APPEND declarations "static const unsigned char ${symbol}[] = {\n${bytes}0};\n")
  endif()
  string(APPEND table "    {\"${file}\", ${symbol}, ${size}},\n")
  math(EXPR count "${count} + 1")
endforeach()

if(count EQUAL 0)
  string(APPEND table "    {\"\", nullptr, 0},\n")
endif()

file(WRITE ${OUT}/resources.cpp
     "// Made by cmake/EmbedModelsStep.cmake.\n#include \"document/library.h\"\n\n${declarations}\n"
     "namespace mimo::document {\n\nconst Resource kResources[] = {\n${table}};\n"
     "const std::size_t kResourceCount = ${count};\n\n}  // namespace mimo::document\n")
if(METHOD STREQUAL "incbin")
  file(WRITE ${OUT}/resources.S "${assembly}  .section .note.GNU-stack,\"\",%progbits\n")
endif()
