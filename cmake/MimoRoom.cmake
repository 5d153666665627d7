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
# Windows, *_posix.cpp for all others.
function(mimo_on_this_platform variable)
  if(WIN32)
    list(FILTER ${variable} EXCLUDE REGEX "_posix\\.cpp$")
  else()
    list(FILTER ${variable} EXCLUDE REGEX "_windows\\.cpp$")
  endif()
  set(${variable} ${${variable}} PARENT_SCOPE)
endfunction()

# mimo_room(<name> ABOUT <text> [DEPENDS <rooms...>] [LIBRARIES <targets...>] [SOURCES <generated files...>]
#           [LINUX_ELSE <file>])
# Makes the target mimo_<name> from all .cpp files below src/<name>. A room without any is header-only. ABOUT says in a
# line what the room does. Whoever sees a room's headers sees those of its LIBRARIES as well. The file of LINUX_ELSE is
# all that the room has on other systems than Linux, and is left out there.
function(mimo_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "ABOUT;LINUX_ELSE" "DEPENDS;LIBRARIES;SOURCES")
  set(folder ${PROJECT_SOURCE_DIR}/src/${name})
  set(include_dir ${MIMO_ROOMS}/${name})
  file(MAKE_DIRECTORY ${include_dir})
  file(CREATE_LINK ${folder} ${include_dir}/${name} SYMBOLIC)

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  mimo_on_this_platform(sources)
  if(room_LINUX_ELSE AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    list(REMOVE_ITEM sources ${folder}/${room_LINUX_ELSE})
  elseif(room_LINUX_ELSE)
    set(sources ${folder}/${room_LINUX_ELSE})
  endif()
  list(APPEND sources ${room_SOURCES})
  list(TRANSFORM room_DEPENDS PREPEND mimo_ OUTPUT_VARIABLE dependencies)
  if(sources)
    add_library(mimo_${name} OBJECT ${sources})
    target_compile_definitions(mimo_${name} PRIVATE MIMO_BUILDING)
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
  set_property(GLOBAL APPEND PROPERTY mimo_rooms ${name})
endfunction()

# mimo_link_room(<target> <room>): links the objects of a room and of all rooms that it depends on.
function(mimo_link_room target name)
  get_property(below GLOBAL PROPERTY mimo_below_${name})
  target_link_libraries(${target} PRIVATE ${below})
endfunction()
