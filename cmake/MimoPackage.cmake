# `cpack` makes a Debian package of what `cmake --install` installs; ./dev package also makes the source tarball.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME libmimo)
string(REPLACE "-" "~" CPACK_PACKAGE_VERSION ${PROJECT_VERSION}${MIMO_VERSION_LABEL})  # 1.0.0~rc1 comes before 1.0.0
set(CPACK_PACKAGE_CONTACT "libmimo contributors")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${PROJECT_SOURCE_DIR}/cmake/description.txt)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)          # MuJoCo, the C++ library, ...: by the versions that were linked
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)    # for packages of programs that are linked with this one
set(CPACK_DEBIAN_PACKAGE_SUGGESTS libosmesa6)   # looked for at run time; the ray renderer needs nothing
include(CPack)
