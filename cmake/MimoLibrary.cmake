# libmimo.so: the objects of all rooms, with nothing but mimo_* visible from outside.
set(exports ${PROJECT_SOURCE_DIR}/src/capi/exports.map)

# A library for another MuJoCo has another name: both can be installed, and a program that is linked with one never loads
# the other.
set(MIMO_LIBRARY_NAME mimo)
if(mujoco_VERSION VERSION_GREATER_EQUAL 4)
  set(MIMO_LIBRARY_NAME mimo-mujoco4)
endif()

if(EMSCRIPTEN)
  add_library(mimo STATIC)
else()
  add_library(mimo SHARED)
endif()
add_library(mimo::mimo ALIAS mimo)
mimo_link_room(mimo capi)
target_include_directories(mimo PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                       $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# A MuJoCo beside the library comes before the system's, wherever the two are: ./dev build --avx, and copies in a host's
# folder.
set_target_properties(mimo PROPERTIES OUTPUT_NAME ${MIMO_LIBRARY_NAME} LINKER_LANGUAGE CXX LINK_DEPENDS ${exports}
                      SOVERSION ${MIMO_ABI_VERSION} VERSION ${MIMO_VERSION})
if(WIN32)
  include(MimoWindows)
elseif(EMSCRIPTEN)
  include(MimoWeb)
elseif(APPLE)
  # What it needs lies beside it, and it says its name for those that it lies beside. Off a Mac, CMake's own properties for
  # this do nothing.
  target_link_options(mimo PRIVATE -Wl,-dead_strip -Wl,-rpath,@loader_path
                      -Wl,-install_name,@rpath/lib${MIMO_LIBRARY_NAME}.dylib)
  set_target_properties(mimo PROPERTIES NO_SONAME ON SKIP_BUILD_RPATH ON MACHO_CURRENT_VERSION ${MIMO_VERSION})
else()
  # Bound when loaded: else a MuJoCo that the host loads later, of another version, could be given to us in the middle.
  target_link_options(mimo PRIVATE -Wl,--version-script=${exports} -Wl,--as-needed -Wl,-z,now)
  # The build folder's file is linked like the installed one: CMake would else reserve room in its RUNPATH by empty
  # entries, and these stand for the current folder.
  set_target_properties(mimo PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH $ORIGIN)
  if(MIMO_DEPENDENCIES)
    # zig's start files do not tell the C library whose handlers of the end are whose, so they are called when the process
    # ends: the library has to be there still, whoever unloads it.
    target_link_options(mimo PRIVATE -Wl,-z,nodelete)
  else()
    # DT_RPATH rather than DT_RUNPATH: in the Python package it also counts for what MuJoCo itself needs.
    target_link_options(mimo PRIVATE -Wl,--disable-new-dtags)
    set_target_properties(mimo PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
  endif()
endif()

# What is built for another system brings its MuJoCo along. For macOS ./dev gives the linker a copy that says another place
# of itself, and keeps the signed one.
if(MIMO_DEPENDENCIES AND NOT EMSCRIPTEN)
  set(mimo_brought $<TARGET_FILE:mujoco::mujoco>)
  if(APPLE)
    file(GLOB mimo_brought ${mujoco_ROOT}/signed/*.dylib)
  endif()
  add_custom_command(TARGET mimo POST_BUILD VERBATIM
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${mimo_brought} $<TARGET_FILE_DIR:mimo>)
endif()
