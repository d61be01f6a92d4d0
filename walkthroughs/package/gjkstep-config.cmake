# find_package(gjkstep) gives
#   gjkstep::core               the algorithm: headers, #include <gjkstep/gjk.hpp>
#   gjkstep::program            the program, where it was installed, too
#   gjkstep_add_golden_test()   see gjkstep_add_golden_test.cmake
include(CMakeFindDependencyMacro)
if(NOT TARGET Eigen3::Eigen)
  find_dependency(Eigen3 3.4)
endif()
include("${CMAKE_CURRENT_LIST_DIR}/gjkstep-targets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/gjkstep_add_golden_test.cmake")
