# Everything from outside. What is missing is collected and reported once, with the names of Debian's packages.
set(mimo_missing "")
set(mimo_missing_packages "")

# Builds for other systems bring their own.
set(mimo_from_sources "")
set(MIMO_DEPENDENCIES "" CACHE PATH "Folder of what ./dev fetches for builds for other systems; empty: the system's")
if(MIMO_DEPENDENCIES)
  include(MimoSources)
endif()

# mimo_find(<what people call it> <Debian package> <arguments of find_package...>)
macro(mimo_find title debian package)
  if(NOT ${package} IN_LIST mimo_from_sources)
    find_package(${package} ${ARGN} QUIET)
  endif()
  if(NOT ${package}_FOUND)
    list(APPEND mimo_missing ${title})
    list(APPEND mimo_missing_packages ${debian})
  endif()
endmacro()

mimo_find("MuJoCo 2.2 or 4.0" libmujoco-dev mujoco 2.2...<4.1 MODULE)  # ours, also where a host prefers packages
if(mujoco_FOUND AND mujoco_VERSION VERSION_GREATER_EQUAL 2.3 AND mujoco_VERSION VERSION_LESS 4.0)
  message(FATAL_ERROR "libmimo needs MuJoCo 2.2 or 4.0, not ${mujoco_VERSION}; set mujoco_ROOT to the folder of another")
endif()
mimo_find("Eigen 3" libeigen3-dev Eigen3)
mimo_find("pugixml" libpugixml-dev pugixml)
mimo_find("fmt" libfmt-dev fmt)
mimo_find("zlib" zlib1g-dev ZLIB)
mimo_find("nlohmann_json" nlohmann-json3-dev nlohmann_json)
mimo_find("threads" libc6-dev Threads)
if(MIMO_PROGRAM)
  mimo_find("CLI11" libcli11-dev CLI11)
  mimo_find("libpng" libpng-dev PNG)
endif()
if(MIMO_TESTS AND NOT CMAKE_CROSSCOMPILING)
  mimo_find("GoogleTest" libgtest-dev GTest)
endif()

# OSMesa is loaded with dlopen at run time, so only its header is needed, and nothing is linked.
find_path(MIMO_OSMESA_INCLUDE_DIR GL/osmesa.h)
if(NOT MIMO_OSMESA_INCLUDE_DIR)
  list(APPEND mimo_missing "the header GL/osmesa.h")
  list(APPEND mimo_missing_packages libosmesa6-dev)
endif()

# Google Highway is used for its headers only; what needs its library is not called.
find_path(MIMO_HIGHWAY_INCLUDE_DIR hwy/highway.h)
if(NOT MIMO_HIGHWAY_INCLUDE_DIR)
  list(APPEND mimo_missing "Google Highway")
  list(APPEND mimo_missing_packages libhwy-dev)
endif()

if(mimo_missing)
  list(JOIN mimo_missing ", " missing)
  list(JOIN mimo_missing_packages " " packages)
  if(NOT mujoco_FOUND AND mujoco_VERSION)
    string(APPEND missing " (there is MuJoCo ${mujoco_VERSION}; set mujoco_ROOT to the folder of another)")
  elseif(NOT mujoco_FOUND AND mujoco_ROOT)
    string(APPEND missing " (there is no MuJoCo in mujoco_ROOT, ${mujoco_ROOT})")
  endif()
  message(FATAL_ERROR "libmimo needs ${missing}.\nOn Debian: apt-get install ${packages}")
endif()

# The static pugixml, where there is one, keeps libmimo.so free of a dependency that users would have to install.
if(TARGET pugixml::static)
  set(MIMO_PUGIXML pugixml::static)
else()
  set(MIMO_PUGIXML pugixml::pugixml)
endif()

# Header-only things as targets, so that rooms name them like everything else.
add_library(mimo_header INTERFACE)
target_include_directories(mimo_header INTERFACE ${PROJECT_SOURCE_DIR}/include)
add_library(mimo_osmesa_header INTERFACE)
target_include_directories(mimo_osmesa_header SYSTEM INTERFACE ${MIMO_OSMESA_INCLUDE_DIR})
add_library(mimo_highway_header INTERFACE)
target_include_directories(mimo_highway_header SYSTEM INTERFACE ${MIMO_HIGHWAY_INCLUDE_DIR})

message(STATUS "MuJoCo ${mujoco_VERSION}")

# MuJoCo 4 counts in 64 bits what 2.2 counted in 32, and a model that could not be counted in 32 is refused by engine.
# Fractions that become whole numbers are still warned of, and the build on 2.2 warns of the rest of the same lines.
if(mujoco_VERSION VERSION_GREATER_EQUAL 4)
  target_compile_options(mujoco::mujoco INTERFACE "$<$<COMPILE_LANGUAGE:C,CXX>:-Wno-conversion;-Wfloat-conversion>")
endif()
