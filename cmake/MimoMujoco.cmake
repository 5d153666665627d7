# MuJoCo 2.2.2 out of its sources, where its makers have no build: the folder mujoco_ROOT as ./dev fills it, and beside it in
# MIMO_DEPENDENCIES what MuJoCo uses. Its own renderer and user interface, which need OpenGL, are left out.
enable_language(C CXX)

file(GLOB mujoco_files RELATIVE ${MIMO_DEPENDENCIES} ${mujoco_ROOT}/src/engine/*.c ${mujoco_ROOT}/src/user/*.cc
     ${mujoco_ROOT}/src/xml/*.cc)
set(qhull_sources geom2 geom global io libqhull mem merge poly2 poly qset random rboxlib stat user usermem userprintf
    userprintf_rbox)
list(TRANSFORM qhull_sources APPEND _r.c)

mimo_foreign_library(mujoco::ccd libccd/src ccd.c mpr.c polytope.c support.c vec3.c)
set(CCD_DOUBLE ON)
configure_file(${MIMO_DEPENDENCIES}/libccd/src/ccd/config.h.cmake.in ${PROJECT_BINARY_DIR}/mujoco/ccd/config.h)
target_include_directories(mujoco_ccd SYSTEM PUBLIC ${PROJECT_BINARY_DIR}/mujoco)
target_compile_definitions(mujoco_ccd PUBLIC CCD_STATIC_DEFINE)
mimo_foreign_library(mujoco::lodepng lodepng lodepng.cpp)
mimo_foreign_library(mujoco::qhullstatic_r qhull/src/libqhull_r ${qhull_sources})
mimo_foreign_library(mujoco::tinyobjloader tinyobjloader tiny_obj_loader.cc)
mimo_foreign_library(mujoco::tinyxml2 tinyxml2 tinyxml2.cpp)
mimo_foreign_library(mujoco::sources . ${mujoco_files})
target_sources(mujoco_sources PRIVATE ${PROJECT_SOURCE_DIR}/cmake/mujoco/sort.c)
set_target_properties(mujoco_sources PROPERTIES C_STANDARD 11)
target_compile_definitions(mujoco_sources PRIVATE _GNU_SOURCE _POSIX_C_SOURCE=200809L MUJOCO_DLL_EXPORTS)
target_compile_options(mujoco_sources PRIVATE -include ${PROJECT_SOURCE_DIR}/cmake/mujoco/sort.h)
target_include_directories(mujoco_sources SYSTEM PUBLIC ${mujoco_ROOT}/include PRIVATE ${mujoco_ROOT}/src)
target_link_libraries(mujoco_sources PRIVATE mujoco::ccd mujoco::lodepng mujoco::qhullstatic_r
                      mujoco::tinyobjloader mujoco::tinyxml2)

# src/engine/functions_web.cpp has what is called instead.
file(STRINGS ${PROJECT_SOURCE_DIR}/src/base/substitutes.h mujoco_wrapped REGEX "^#define MIMO_SUBSTITUTES_OF_")
string(REGEX MATCHALL "DO\\([a-z0-9]+\\)" mujoco_wrapped "${mujoco_wrapped}")
list(TRANSFORM mujoco_wrapped REPLACE "DO\\((.*)\\)" "-Wl,--wrap=\\1")

add_library(mujoco::mujoco INTERFACE IMPORTED)
set_target_properties(mujoco::mujoco PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${mujoco_ROOT}/include
                                                INTERFACE_LINK_LIBRARIES mujoco_sources
                                                INTERFACE_LINK_OPTIONS "${mujoco_wrapped}")
