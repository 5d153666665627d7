# The rooms: one object library for each folder of src/.
#
# Headers are included as "engine/guard.h". Each room has an include directory of its own that holds nothing but a
# link to its folder. A room sees those of the rooms that it names in DEPENDS, and not of what these name: a header of
# any other room is simply not found. That is how the direction of dependencies is enforced. docs/make_rooms.py draws
# the page of rooms from these calls, and tests that no room is named whose headers nobody includes.

# The links lie in the same place of every build folder, so that ccache shares what it keeps between build folders that lie
# beside each other.
set(MIMO_ROOMS ${CMAKE_BINARY_DIR}/rooms)

# mimo_on_this_platform(<variable>): leaves out of a list of sources what is for another system: *_windows.cpp is for
# Windows, *_web.cpp for WebAssembly, *_posix.cpp for all others, and for WebAssembly where it has no file of its own;
# *_linux.cpp is for Linux, *_elsewhere.cpp for all others.
function(mimo_on_this_platform variable)
  if(WIN32)
    list(FILTER ${variable} EXCLUDE REGEX "_posix\\.cpp$")
  else()
    list(FILTER ${variable} EXCLUDE REGEX "_windows\\.cpp$")
  endif()
  if(EMSCRIPTEN)
    set(web ${${variable}})
    list(FILTER web INCLUDE REGEX "_web\\.cpp$")
    list(TRANSFORM web REPLACE "_web\\.cpp$" "_posix.cpp")
    list(REMOVE_ITEM ${variable} ${web})
  else()
    list(FILTER ${variable} EXCLUDE REGEX "_web\\.cpp$")
  endif()
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    list(FILTER ${variable} EXCLUDE REGEX "_elsewhere\\.cpp$")
  else()
    list(FILTER ${variable} EXCLUDE REGEX "_linux\\.cpp$")
  endif()
  set(${variable} ${${variable}} PARENT_SCOPE)
endfunction()

# mimo_room(<name> ABOUT <text> [OUTSIDE] [APART <files...>] [DEPENDS <rooms...>] [LIBRARIES <targets...>] [SOURCES <generated files...>]
#           [LINUX_ELSE <file>])
# Makes the target mimo_<name> from all .cpp files below src/<name>. A room without any is header-only. ABOUT says in a
# line what the room does. Whoever sees a room's headers sees those of its LIBRARIES as well. The file of LINUX_ELSE is
# all that the room has on other systems than Linux, and is left out there. A room with OUTSIDE is a part of programs,
# not of libmimo.so: it is written against the public headers, like any user's program. The files of a room are compiled in
# batches, which read headers once; a file of APART has a name of its own that another file gives to something else, and is
# compiled alone.
function(mimo_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "OUTSIDE" "ABOUT;LINUX_ELSE" "APART;DEPENDS;LIBRARIES;SOURCES")
  set(folder ${PROJECT_SOURCE_DIR}/src/${name})
  set(include_dir ${MIMO_ROOMS}/${name})
  file(MAKE_DIRECTORY ${include_dir})
  file(CREATE_LINK ${folder} ${include_dir}/${name} SYMBOLIC)

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  mimo_on_this_platform(sources)
  foreach(source IN LISTS sources)
    if(source MATCHES "_windows\\.cpp$")  # a batch would see the macros of Windows' headers
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  if(room_LINUX_ELSE AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    list(REMOVE_ITEM sources ${folder}/${room_LINUX_ELSE})
  elseif(room_LINUX_ELSE)
    set(sources ${folder}/${room_LINUX_ELSE})
  endif()
  list(APPEND sources ${room_SOURCES})
  list(TRANSFORM room_DEPENDS PREPEND mimo_ OUTPUT_VARIABLE dependencies)
  if(sources)
    add_library(mimo_${name} OBJECT ${sources})
    if(room_OUTSIDE)
      target_link_libraries(mimo_${name} PUBLIC mimo::mimo)
    else()
      target_compile_definitions(mimo_${name} PRIVATE MIMO_BUILDING)
    endif()
    set_target_properties(mimo_${name} PROPERTIES UNITY_BUILD ${MIMO_UNITY} UNITY_BUILD_BATCH_SIZE 8)
    set_source_files_properties(${room_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    if(MIMO_UNITY AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
      target_compile_options(mimo_${name} PRIVATE -Wno-shadow)  # it warns of names that other files of a batch have
    endif()
    target_include_directories(mimo_${name} PUBLIC ${include_dir})
    target_link_libraries(mimo_${name} PUBLIC ${room_LIBRARIES} PRIVATE ${dependencies})
  else()
    add_library(mimo_${name} INTERFACE)
    target_include_directories(mimo_${name} INTERFACE ${include_dir})
    target_link_libraries(mimo_${name} INTERFACE ${room_LIBRARIES})
  endif()

  # The room and all rooms below it. Objects, unlike include directories, do not travel along links.
  set(below mimo_${name})
  foreach(dependency IN LISTS room_DEPENDS)
    get_property(further GLOBAL PROPERTY mimo_below_${dependency})
    list(APPEND below ${further})
  endforeach()
  list(REMOVE_DUPLICATES below)
  set_property(GLOBAL PROPERTY mimo_below_${name} ${below})
  if(NOT room_OUTSIDE)
    set_property(GLOBAL APPEND PROPERTY mimo_rooms ${name})
  endif()
endfunction()

# mimo_program(<target> <room> <output name>): a program of the objects of a room with OUTSIDE, and of those below it.
function(mimo_program target room output)
  add_executable(${target})
  mimo_link_room(${target} ${room})
  # The library's folder in the build and where it is installed, see MimoLibrary.cmake; in packages for other systems it
  # lies beside.
  set(rpath $ORIGIN/../lib $ORIGIN/../${CMAKE_INSTALL_LIBDIR})
  if(MIMO_DEPENDENCIES)
    list(APPEND rpath $ORIGIN)
  endif()
  list(REMOVE_DUPLICATES rpath)
  # Windows' linker writes an import library of a program that exports functions, as those of FMI. Under the program's
  # name, it would replace libmimo's.
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME ${output} ARCHIVE_OUTPUT_NAME ${target}
                                             BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "${rpath}")
  if(APPLE)
    target_link_options(${target} PRIVATE -Wl,-rpath,@loader_path/../lib -Wl,-rpath,@loader_path)
  endif()
endfunction()

# mimo_compile_as_program(<room>): a room with OUTSIDE spends its time in the library, and CLI11 takes long to compile: a
# minute a file with sanitizers. It is optimised little.
function(mimo_compile_as_program room)
  target_compile_options(mimo_${room} PRIVATE $<IF:$<BOOL:${MIMO_SANITIZE}>,-O0,-O1>)
endfunction()

# mimo_link_room(<target> <room>): links the objects of a room and of all rooms that it depends on.
function(mimo_link_room target name)
  get_property(below GLOBAL PROPERTY mimo_below_${name})
  target_link_libraries(${target} PRIVATE ${below})
endfunction()
