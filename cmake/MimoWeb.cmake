# mimo.wasm, the library as one WebAssembly module. It needs no JavaScript of Emscripten's: bindings/javascript loads it.
# The library of the same name is for programs that Emscripten links whole, such as the C tests.
file(STRINGS ${exports} mimo_functions REGEX "^    mimo_[a-z0-9_]+;")
list(TRANSFORM mimo_functions REPLACE " *(.*);" "_\\1")
list(APPEND mimo_functions _malloc _free _mimo_round_as)  # the last for pages of recordings: src/engine/functions_web.cpp
list(JOIN mimo_functions "\n" mimo_functions)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/functions.txt CONTENT "${mimo_functions}\n" @ONLY)

add_executable(mimo_module ${PROJECT_SOURCE_DIR}/cmake/web/open.c)
mimo_link_room(mimo_module capi)
set_target_properties(mimo_module PROPERTIES OUTPUT_NAME mimo SUFFIX .wasm LINKER_LANGUAGE CXX
                      LINK_DEPENDS "${exports};${CMAKE_CURRENT_LIST_FILE}"
                      RUNTIME_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
target_link_options(mimo_module PRIVATE --no-entry -sSTANDALONE_WASM=1 -sALLOW_TABLE_GROWTH=1
                    -sEXPORTED_FUNCTIONS=@${CMAKE_CURRENT_BINARY_DIR}/functions.txt)
