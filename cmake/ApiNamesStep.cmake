# Build step of ApiNames.cmake: writes into OUT, sorted by bytes, the functions, constants, structs and members of structs
# that HEADERS declare. They are written plainly enough for regular expressions; abi.supports compares what comes out
# with the lists of functions and structs.
set(names "")
foreach(header IN LISTS HEADERS)
  if(header MATCHES "mimo_export")
    continue()
  endif()
  file(READ ${header} text)
  # Characters that lists give a meaning to, and comments.
  string(REPLACE ";" "@" text "${text}")
  string(REPLACE "[" "<" text "${text}")
  string(REPLACE "]" ">" text "${text}")
  string(ASCII 1 begin)
  string(ASCII 2 end)
  string(REPLACE "/*" "${begin}" text "${text}")
  string(REPLACE "*/" "${end}" text "${text}")
  string(REGEX REPLACE "${begin}[^${end}]*${end}" "" text "${text}")

  string(REGEX MATCHALL "#define MIMO_[A-Z0-9_]+ +[-(0-9]" constants "${text}")
  foreach(constant IN LISTS constants)
    string(REGEX MATCH "MIMO_[A-Z0-9_]+" name "${constant}")
    list(APPEND names ${name})
  endforeach()

  string(REGEX MATCHALL "MIMO_API [^@]*@" functions "${text}")
  foreach(function IN LISTS functions)
    string(REGEX MATCH "(mimo_[a-z0-9_]+)\\(" name "${function}")
    list(APPEND names ${CMAKE_MATCH_1})
  endforeach()

  string(REGEX MATCHALL "typedef struct mimo_[a-z0-9_]+ {[^}]*}" structs "${text}")
  foreach(struct IN LISTS structs)
    string(REGEX MATCH "mimo_[a-z0-9_]+" name "${struct}")
    list(APPEND names ${name})
    string(REGEX MATCHALL "[a-z0-9_]+(<[^>]*>)?@" members "${struct}")
    foreach(member IN LISTS members)
      string(REGEX MATCH "^[a-z0-9_]+" member "${member}")
      list(APPEND names ${name}.${member})
    endforeach()
  endforeach()
endforeach()
list(SORT names)

list(JOIN names "\",\n    \"" lines)
file(WRITE ${OUT} "// Made by cmake/ApiNamesStep.cmake.\n#include \"capi/names.h\"\n\nnamespace mimo::capi {\n\n"
                  "const std::string_view kNames[] = {\n    \"${lines}\",\n};\n"
                  "const std::size_t kNameCount = std::size(kNames);\n\n}  // namespace mimo::capi\n")
