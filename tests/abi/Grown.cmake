# The library of the next minor version, made out of this one's sources: that programs of old run on it, and that its own
# run on today's library as far as they use nothing new. Only the border is compiled again; no room below sees headers.
set(grown ${CMAKE_CURRENT_BINARY_DIR}/grown)
file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include/mimo/*
                                                                   ${PROJECT_SOURCE_DIR}/include/mimo/*/*)
list(FILTER headers EXCLUDE REGEX "/(hpp|experimental)$")
set(grown_headers ${headers})
list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/)
list(TRANSFORM grown_headers PREPEND ${grown}/)
add_custom_command(
  OUTPUT ${grown_headers} ${grown}/exports.map ${grown}/names.cpp ${grown}/grown.cpp
  COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_SOURCE_DIR}/make_grown ${grown}
  DEPENDS ${headers} ${PROJECT_SOURCE_DIR}/interface/interface.json ${PROJECT_SOURCE_DIR}/interface/targets/library.py
          ${CMAKE_CURRENT_SOURCE_DIR}/make_grown
  COMMENT "Growing the interface" VERBATIM)
add_custom_target(grown_headers DEPENDS ${grown_headers})

file(GLOB border CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/capi/*.cpp)
list(FILTER border EXCLUDE REGEX "/names.cpp$")
get_property(below GLOBAL PROPERTY mimo_below_capi)
list(REMOVE_ITEM below mimo_capi)
add_library(mimo_grown SHARED ${border} ${grown}/names.cpp ${grown}/grown.cpp)
add_dependencies(mimo_grown grown_headers)
set_target_properties(mimo_grown PROPERTIES UNITY_BUILD ${MIMO_UNITY} UNITY_BUILD_BATCH_SIZE 8)  # as rooms are
target_compile_definitions(mimo_grown PRIVATE MIMO_BUILDING)
target_include_directories(mimo_grown BEFORE PRIVATE ${grown}/include ${MIMO_ROOMS}/capi)
target_link_libraries(mimo_grown PRIVATE ${below})
target_link_options(mimo_grown PRIVATE -Wl,--version-script=${grown}/exports.map -Wl,--as-needed -Wl,-z,now)
set_target_properties(mimo_grown PROPERTIES OUTPUT_NAME mimo LIBRARY_OUTPUT_DIRECTORY ${grown} LINKER_LANGUAGE CXX
                      LINK_DEPENDS ${grown}/exports.map SOVERSION ${MIMO_ABI_VERSION})

foreach(caller grown_caller grown_linked)
  add_executable(abi_${caller} ${caller}.c)
  add_dependencies(abi_${caller} grown_headers)
  target_include_directories(abi_${caller} PRIVATE ${grown}/include ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(abi_${caller} PRIVATE $<TARGET_LINKER_FILE:mimo_grown> m ${CMAKE_DL_LIBS})
  add_dependencies(abi_${caller} mimo_grown)
endforeach()
add_test(NAME abi.grown
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/check_grown $<TARGET_FILE:mimo> $<TARGET_FILE:mimo_grown>
                 $<TARGET_FILE:abi_caller_today> $<TARGET_FILE:abi_grown_caller> $<TARGET_FILE:abi_grown_linked>
                 ${grown}/exports.map)
