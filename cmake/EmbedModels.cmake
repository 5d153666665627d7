# mimo_embed_models(<variable> <folder>): puts every .xml and .png below the folder (except art/) into the library.
#
# Sets the variable to the sources that a target needs for it; they define what src/document/library.h declares.
# The files are taken in by the assembler (.incbin), which is quick and takes no memory however large they are;
# where that does not work they become C arrays. MIMO_EMBED_ARRAYS=ON asks for the arrays.
include(CheckSourceCompiles)

option(MIMO_EMBED_ARRAYS "Embed models as C arrays even where the assembler could include them" OFF)

function(mimo_embed_models variable folder)
  file(GLOB_RECURSE files RELATIVE ${folder} CONFIGURE_DEPENDS ${folder}/*.xml ${folder}/*.png)
  list(FILTER files EXCLUDE REGEX "^art/")
  list(SORT files)
  set(paths ${files})
  list(TRANSFORM paths PREPEND ${folder}/)

  # The list is a file of its own, so that a file that disappears is noticed as well.
  set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  list(JOIN files "\n" lines)
  file(CONFIGURE OUTPUT ${out}/models.list CONTENT "${lines}\n" @ONLY)

  check_source_compiles(C "__asm__(\".incbin \\\"${out}/models.list\\\"\"); int main(void) { return 0; }" MIMO_HAVE_INCBIN)
  set(method arrays)
  set(sources ${out}/resources.cpp)
  if(MIMO_HAVE_INCBIN AND NOT MIMO_EMBED_ARRAYS AND CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    set(method incbin)
    list(APPEND sources ${out}/resources.S)
    set_source_files_properties(${out}/resources.S PROPERTIES OBJECT_DEPENDS "${paths}")
  endif()

  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedModelsStep.cmake)
  add_custom_command(
    OUTPUT ${sources}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DLIST=${out}/models.list -DOUT=${out} -DMETHOD=${method} -P ${script}
    DEPENDS ${out}/models.list ${paths} ${script}
    COMMENT "Embedding models" VERBATIM)
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()
