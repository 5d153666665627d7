# What `cmake --install` puts where, and the packages by which other projects find it.
include(CMakePackageConfigHelpers)

install(TARGETS mimo EXPORT mimoTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET mimo_program)
  install(TARGETS mimo_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY include/mimo DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h PATTERN *.hpp)
install(FILES interface/interface.json DESTINATION ${CMAKE_INSTALL_DATADIR}/mimo)
install(DIRECTORY models/ DESTINATION ${CMAKE_INSTALL_DATADIR}/mimo/models
        FILES_MATCHING PATTERN *.xml PATTERN *.png PATTERN *.md PATTERN art EXCLUDE)
# What ./dev web has made, for mimo export --html.
install(FILES ${PROJECT_BINARY_DIR}/web/recording.html DESTINATION ${CMAKE_INSTALL_DATADIR}/mimo/web OPTIONAL)
if(EXISTS ${PROJECT_SOURCE_DIR}/src/cli/mimo.1)
  install(FILES src/cli/mimo.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()

# Articles and examples, beside each other as in the repository: they refer to each other (tests/readme/check_links).
set(articles abi benchmark bindings cameras cohort coming-from-mimo differences engines learning packages platforms python robustness scale state-format tasks vision web zoo)
list(TRANSFORM articles REPLACE ".+" "docs/\\0.md")
install(FILES ${articles} DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT documents)
install(DIRECTORY docs/guide docs/adr docs/tutorials DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT documents
        FILES_MATCHING PATTERN *.md)
install(DIRECTORY docs/data DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT documents FILES_MATCHING PATTERN *.csv)
install(DIRECTORY docs/images DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT documents FILES_MATCHING PATTERN *.png)
foreach(language c cpp csharp javascript lua matlab policies python rust senses)
  install(DIRECTORY examples/${language} DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
          COMPONENT documents PATTERN __pycache__ EXCLUDE)
endforeach()
foreach(language csharp javascript matlab rust)
  install(FILES bindings/${language}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/bindings/${language}
          COMPONENT documents)
endforeach()
install(FILES models/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/models COMPONENT documents)
install(FILES CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT documents)

# find_package(mimo) and the target mimo::mimo
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mimo)
install(EXPORT mimoTargets NAMESPACE mimo:: FILE mimoTargets.cmake DESTINATION ${package_dir})
install(FILES cmake/mimoConfig.cmake DESTINATION ${package_dir})
if(WIN32)  # for Microsoft's linker, which reads another kind of import library
  install(FILES ${mimo_lib} DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
# Functions are added, never removed (docs/abi.md): 1.1 serves those who ask for 1.0. A candidate says that it is one.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mimoConfigVersion.cmake VERSION ${MIMO_VERSION_TEXT}
                                 COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mimoConfigVersion.cmake DESTINATION ${package_dir})

# pkg-config --cflags --libs mimo. A system's library lies where the linker looks. Any other installation can be moved, so
# its paths begin at the file's own folder, and a program finds the library where it was when the program was linked.
# pkg-config sorts 1.0.0~rc1 before 1.0.0, as Debian does.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(MIMO_PC_PREFIX /usr)
  set(MIMO_PC_RPATH "")
else()
  file(RELATIVE_PATH MIMO_PC_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" MIMO_PC_PREFIX "\${pcfiledir}/${MIMO_PC_PREFIX}")
  set(MIMO_PC_RPATH " -Wl,-rpath,\${libdir}")
endif()
string(REPLACE "-" "~" MIMO_PC_VERSION ${MIMO_VERSION_TEXT})
configure_file(cmake/mimo.pc.in mimo.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/mimo.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
