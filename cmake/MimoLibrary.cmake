# libmimo.so: the objects of all rooms, with nothing but mimo_* visible from outside.
set(exports ${PROJECT_SOURCE_DIR}/src/capi/exports.map)
file(STRINGS ${exports} version_node REGEX "^MIMO_${MIMO_ABI_VERSION}[.]")
if(NOT version_node)
  message(FATAL_ERROR "${exports} does not name a node of MIMO_${MIMO_ABI_VERSION}, the ABI version in status.h")
endif()

add_library(mimo SHARED)
add_library(mimo::mimo ALIAS mimo)
mimo_link_room(mimo capi)
target_include_directories(mimo PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                       $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# A MuJoCo beside the library comes before the system's, wherever the two are: ./dev build --avx, and copies in a host's
# folder.
set_target_properties(mimo PROPERTIES LINKER_LANGUAGE CXX LINK_DEPENDS ${exports}
                      SOVERSION ${MIMO_ABI_VERSION} VERSION ${MIMO_VERSION})
if(WIN32)
  include(MimoWindows)
elseif(APPLE)
  target_link_options(mimo PRIVATE -Wl,-dead_strip)
  set_target_properties(mimo PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH @loader_path
                        INSTALL_NAME_DIR @rpath MACHO_CURRENT_VERSION ${MIMO_VERSION})
else()
  # Bound when loaded: else a MuJoCo that the host loads later, of another version, could be given to us in the middle.
  target_link_options(mimo PRIVATE -Wl,--version-script=${exports} -Wl,--as-needed -Wl,-z,now)
  # The build folder's file is linked like the installed one: CMake would else reserve room in its RUNPATH by empty
  # entries, and these stand for the current folder.
  set_target_properties(mimo PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH $ORIGIN INSTALL_RPATH_USE_LINK_PATH ON)
endif()
