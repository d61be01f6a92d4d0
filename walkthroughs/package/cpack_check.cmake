# Read by cpack before it packs: without dpkg-shlibdeps it would make, in silence, a package that depends on no library.
find_program(GJKSTEP_SHLIBDEPS dpkg-shlibdeps)
find_program(GJKSTEP_FILE file)
if(CPACK_GENERATOR STREQUAL "DEB" AND NOT (GJKSTEP_SHLIBDEPS AND GJKSTEP_FILE))
  message(FATAL_ERROR "cpack needs dpkg-shlibdeps and file to find the libraries; apt-get install dpkg-dev file")
endif()
