# A Debian package of the headers, the CMake package and the program.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gjkstep)
set(CPACK_PACKAGE_VENDOR gjkstep)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "stepper and reference for the GJK collision test")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Runs the Gilbert-Johnson-Keerthi collision test as ARL-TR-7474 explains it, \
draws each of its decisions, and compares pictures. With the headers of the algorithm and a CMake package.")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "gjkstep <gjkstep@localhost>")  # whoever builds it
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# Libraries are found by dpkg-shlibdeps; what no library tells is the fonts, Eigen for the headers, and OSMesa, which is loaded
# when something is drawn.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, libeigen3-dev (>= 3.4)")
if(OSMESA_FOUND)
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", libosmesa6")
endif()
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/cpack_check.cmake)
include(CPack)
