# libmimo.so: the objects of all rooms, with nothing but mimo_* visible from outside.
set(exports ${PROJECT_SOURCE_DIR}/src/capi/exports.map)
file(STRINGS ${exports} version_node REGEX "^MIMO_${MIMO_ABI_VERSION} ")
if(NOT version_node)
  message(FATAL_ERROR "${exports} does not name MIMO_${MIMO_ABI_VERSION}, the ABI version in mimo.h")
endif()

add_library(mimo SHARED)
add_library(mimo::mimo ALIAS mimo)
mimo_link_room(mimo capi)
target_include_directories(mimo PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                       $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# Bound when loaded: else a MuJoCo that the host loads later, of another version, could be given to us in the middle.
target_link_options(mimo PRIVATE -Wl,--version-script=${exports} -Wl,--as-needed -Wl,-z,now)
set_target_properties(mimo PROPERTIES LINKER_LANGUAGE CXX LINK_DEPENDS ${exports}
                      SOVERSION ${MIMO_ABI_VERSION} VERSION ${MIMO_VERSION}
                      INSTALL_RPATH_USE_LINK_PATH ON)
# In the build folder, another build of the same MuJoCo beside libmimo.so takes the place of the system's: ./dev build --avx
set_property(TARGET mimo PROPERTY BUILD_RPATH $ORIGIN)
