# mimo_list_api_names(<variable> <include folder> <out folder>): makes a source out of the public headers with all names
# of the interface, for mimo_supports; it defines what src/capi/names.h declares. Sets the variable to its path.
function(mimo_list_api_names variable include out)
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/mimo/*.h)
  list(TRANSFORM headers REPLACE "^.*/" "${include}/mimo/")
  set(script ${PROJECT_SOURCE_DIR}/cmake/ApiNamesStep.cmake)
  add_custom_command(
    OUTPUT ${out}/api_names.cpp
    COMMAND ${CMAKE_COMMAND} "-DHEADERS=${headers}" -DOUT=${out}/api_names.cpp -P ${script}
    DEPENDS ${headers} ${script}
    COMMENT "Listing the names of the interface" VERBATIM)
  set(${variable} ${out}/api_names.cpp PARENT_SCOPE)
endfunction()
