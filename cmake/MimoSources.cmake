# What builds for other systems need beside MuJoCo, out of the folder MIMO_DEPENDENCIES, which ./dev fills: headers, and the
# sources of pugixml, zlib and libpng, which become part of what is linked with them.
set(mimo_from_sources Eigen3 fmt pugixml CLI11 PNG ZLIB nlohmann_json)
include_directories(SYSTEM ${MIMO_DEPENDENCIES}/include)
foreach(target Eigen3::Eigen CLI11::CLI11 nlohmann_json::nlohmann_json)
  add_library(${target} INTERFACE IMPORTED)
endforeach()
foreach(package IN LISTS mimo_from_sources)
  set(${package}_FOUND TRUE)
endforeach()
set(MIMO_OSMESA_INCLUDE_DIR ${MIMO_DEPENDENCIES}/include)
set(MIMO_HIGHWAY_INCLUDE_DIR ${MIMO_DEPENDENCIES}/include)

# The MuJoCo that goes along is its makers' build.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  add_compile_definitions(MIMO_MUJOCO_HAS_AVX)
endif()

# mimo_foreign_library(<target> <folder> <sources...>): sources of others, whose warnings are not our business.
function(mimo_foreign_library target folder)
  string(REPLACE "::" "_" name ${target})
  list(TRANSFORM ARGN PREPEND ${MIMO_DEPENDENCIES}/${folder}/)
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${ARGN})
  add_library(${target} ALIAS ${name})
  target_include_directories(${name} SYSTEM PUBLIC ${MIMO_DEPENDENCIES}/${folder})
  target_compile_options(${name} PRIVATE -w -Wno-error)
endfunction()

mimo_foreign_library(pugixml::static pugixml/src pugixml.cpp)
mimo_foreign_library(ZLIB::ZLIB zlib adler32.c compress.c crc32.c deflate.c inffast.c inflate.c inftrees.c trees.c zutil.c)
if(APPLE)  # by this word it takes it for the system of the nineties
  target_compile_options(ZLIB_ZLIB PRIVATE -UTARGET_OS_MAC)
endif()
if(MIMO_PROGRAM)
  mimo_foreign_library(PNG::PNG libpng png.c pngerror.c pngget.c pngmem.c pngpread.c pngread.c pngrio.c pngrtran.c pngrutil.c
                       pngset.c pngtrans.c pngwio.c pngwrite.c pngwtran.c pngwutil.c)
  target_compile_definitions(PNG_PNG PRIVATE PNG_ARM_NEON_OPT=0)
  if(APPLE)
    target_compile_options(PNG_PNG PRIVATE -UTARGET_OS_MAC)  # likewise
  endif()
  target_link_libraries(PNG_PNG PUBLIC ZLIB::ZLIB)
endif()

if(EMSCRIPTEN)
  include(MimoHdf5)
endif()
