# libmimo as Windows has it: bin/mimo.dll beside its MuJoCo, and lib/ with libmimo.dll.a for mingw, mimo.lib for MSVC.
set_target_properties(mimo PROPERTIES PREFIX "" IMPORT_PREFIX lib)
find_program(MIMO_DLLTOOL NAMES llvm-dlltool llvm-dlltool-14 REQUIRED)
mark_as_advanced(MIMO_DLLTOOL)

# The linker lists what the library exports, which is what MIMO_API marks; MSVC reads another kind of list.
set(mimo_def ${PROJECT_BINARY_DIR}/mimo.def)
target_link_options(mimo PRIVATE -Wl,--output-def=${mimo_def})
set(mimo_lib ${CMAKE_ARCHIVE_OUTPUT_DIRECTORY}/mimo.lib)
add_custom_command(TARGET mimo POST_BUILD
  COMMAND ${MIMO_DLLTOOL} -m i386:x86-64 -D mimo.dll -d ${mimo_def} -l ${mimo_lib}
  BYPRODUCTS ${mimo_lib} VERBATIM)
