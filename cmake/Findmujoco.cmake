# Finds MuJoCo and makes the target mujoco::mujoco; sets mujoco_FOUND and mujoco_VERSION.
#
# Without mujoco_ROOT it is the system's CMake package (Debian: libmujoco-dev). mujoco_ROOT may name an installed
# package, the folder of a release archive (include/, lib/) or the folder of the Python wheel (include/ and the library, for
# Windows also libmujoco.dll.a, which ./dev makes): the last two bring no CMake package, so their files are looked up here.
if(NOT mujoco_ROOT AND DEFINED ENV{mujoco_ROOT})
  set(mujoco_ROOT $ENV{mujoco_ROOT})
endif()

if(mujoco_ROOT AND EXISTS ${mujoco_ROOT}/src/engine)
  include(MimoMujoco)
elseif(mujoco_ROOT)
  file(GLOB mujoco_files ${mujoco_ROOT}/libmujoco.so* ${mujoco_ROOT}/lib/libmujoco.so* ${mujoco_ROOT}/libmujoco.*dylib
       ${mujoco_ROOT}/mujoco-*.dll)
  find_path(mujoco_INCLUDE_DIR mujoco/mujoco.h PATHS ${mujoco_ROOT}/include NO_DEFAULT_PATH)
  if(mujoco_files AND mujoco_INCLUDE_DIR AND NOT TARGET mujoco::mujoco)
    list(GET mujoco_files 0 mujoco_library)
    add_library(mujoco::mujoco SHARED IMPORTED)
    set_target_properties(mujoco::mujoco PROPERTIES IMPORTED_LOCATION ${mujoco_library}
                          INTERFACE_INCLUDE_DIRECTORIES ${mujoco_INCLUDE_DIR})
    if(WIN32)
      set_target_properties(mujoco::mujoco PROPERTIES IMPORTED_IMPLIB ${mujoco_ROOT}/libmujoco.dll.a)
    endif()
  elseif(NOT TARGET mujoco::mujoco)
    find_package(mujoco CONFIG QUIET PATHS ${mujoco_ROOT} NO_DEFAULT_PATH)
  endif()
elseif(NOT TARGET mujoco::mujoco)
  find_package(mujoco CONFIG QUIET)
endif()

if(TARGET mujoco::mujoco)
  # Debian's package names a folder of libqhull's that it does not install, which CMake refuses.
  set(mujoco_include_dirs "")
  get_target_property(mujoco_listed_dirs mujoco::mujoco INTERFACE_INCLUDE_DIRECTORIES)
  foreach(mujoco_dir IN LISTS mujoco_listed_dirs)
    if(EXISTS ${mujoco_dir})
      list(APPEND mujoco_include_dirs ${mujoco_dir})
    endif()
  endforeach()
  set_target_properties(mujoco::mujoco PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${mujoco_include_dirs}")
  find_file(mujoco_header mujoco/mujoco.h PATHS ${mujoco_include_dirs} NO_DEFAULT_PATH NO_CACHE)
  file(STRINGS "${mujoco_header}" mujoco_line REGEX "^#define mjVERSION_HEADER [0-9]+")
  if(mujoco_line MATCHES " ([0-9])([0-9])([0-9])$")  # 222
    set(mujoco_VERSION ${CMAKE_MATCH_1}.${CMAKE_MATCH_2}.${CMAKE_MATCH_3})
  elseif(mujoco_line MATCHES " ([0-9]+)([0-9][0-9][0-9])([0-9][0-9][0-9])$")  # 4000001, since 3.5
    math(EXPR mujoco_minor "1${CMAKE_MATCH_2} - 1000")
    math(EXPR mujoco_patch "1${CMAKE_MATCH_3} - 1000")
    set(mujoco_VERSION ${CMAKE_MATCH_1}.${mujoco_minor}.${mujoco_patch})
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(mujoco REQUIRED_VARS mujoco_VERSION VERSION_VAR mujoco_VERSION
                                  HANDLE_VERSION_RANGE)
