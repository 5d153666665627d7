# mimo_read_version(<header>): sets MIMO_VERSION ("0.1.0") and MIMO_ABI_VERSION (0) from the header's macros,
# so that header, SONAME and packages cannot disagree.
function(mimo_read_version header)
  foreach(part VERSION_MAJOR VERSION_MINOR VERSION_PATCH ABI_VERSION)
    file(STRINGS ${header} line REGEX "^#define MIMO_${part} [0-9]+")
    if(NOT line MATCHES "MIMO_${part} ([0-9]+)")
      message(FATAL_ERROR "${header} does not define MIMO_${part} as a number")
    endif()
    set(${part} ${CMAKE_MATCH_1})
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  set(MIMO_VERSION ${VERSION_MAJOR}.${VERSION_MINOR}.${VERSION_PATCH} PARENT_SCOPE)
  set(MIMO_ABI_VERSION ${ABI_VERSION} PARENT_SCOPE)
endfunction()
