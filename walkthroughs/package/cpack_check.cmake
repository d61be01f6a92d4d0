# Read by cpack before it packs: without dpkg-shlibdeps it would make a package that depends on no library, and not say so.
find_program(GJKSTEP_SHLIBDEPS dpkg-shlibdeps)
if(CPACK_GENERATOR STREQUAL "DEB" AND NOT GJKSTEP_SHLIBDEPS)
  message(FATAL_ERROR "cpack needs dpkg-shlibdeps to find the libraries that gjkstep needs; apt-get install dpkg-dev")
endif()
