# gjkstep_add_golden_test(NAME name SCENE scene... EXPECTED folder [OPTIONS option...])
#
# A test for CTest that draws scenes and compares their pictures with accepted ones. Call enable_testing() before it.
#
#   NAME      of the test; any text without a semicolon
#   SCENE     scene files, relative to the current source folder, or names that `gjkstep list` shows
#   EXPECTED  folder of the accepted pictures, of this test alone; it need not be there yet
#   OPTIONS   for `gjkstep render`, such as --size 640x360 --strip
#
# A test that fails keeps what it drew, and a report, in golden/NAME of the build folder: open report/index.html. To
# accept what is drawn now, the first time or after a change, ask for it, then look at what version control shows:
#
#     GJKSTEP_ACCEPT=1 ctest --test-dir build -R NAME --verbose
cmake_policy(GET CMP0110 gjkstep_any_test_name)  # of who includes this: may names of tests hold spaces?
cmake_policy(PUSH)
cmake_policy(VERSION 3.25)

# In OUT: the folder of the test, below the build folder. Stops where another test has it, or the accepted pictures.
function(gjkstep_reserve_golden_folders name expected out)
  string(REGEX REPLACE "[^A-Za-z0-9 _+.-]|^[.]+" "_" folder "${name}")
  cmake_path(APPEND CMAKE_BINARY_DIR golden "${folder}" OUTPUT_VARIABLE folder)
  foreach(path IN ITEMS "${folder}" "${expected}")
    get_property(other GLOBAL PROPERTY "gjkstep golden ${path}")
    if(other)
      message(FATAL_ERROR "gjkstep_add_golden_test: '${name}' and '${other}' share the folder ${path}; \
each test needs a name and an EXPECTED of its own")
    endif()
    set_property(GLOBAL PROPERTY "gjkstep golden ${path}" "${name}")
  endforeach()
  set(${out} "${folder}" PARENT_SCOPE)
endfunction()

function(gjkstep_add_golden_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;EXPECTED" "SCENE;OPTIONS")
  foreach(needed IN ITEMS NAME SCENE EXPECTED)
    if("${arg_${needed}}" STREQUAL "")
      message(FATAL_ERROR "gjkstep_add_golden_test: ${needed} is missing; expected NAME name SCENE scene... \
EXPECTED folder [OPTIONS option...]")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS OR arg_NAME MATCHES ";")
    message(FATAL_ERROR "gjkstep_add_golden_test: '${arg_UNPARSED_ARGUMENTS}' is not expected in '${arg_NAME}', \
nor a semicolon in a name")
  endif()
  if(DEFINED gjkstep_any_test_name AND NOT gjkstep_any_test_name STREQUAL "NEW" AND arg_NAME MATCHES "[^A-Za-z0-9_.+-]")
    message(FATAL_ERROR "gjkstep_add_golden_test: '${arg_NAME}' has more than letters, digits and _.+-, which takes \
cmake_minimum_required(VERSION 3.19) or newer")
  endif()
  if(NOT TARGET gjkstep::program)
    message(FATAL_ERROR "gjkstep_add_golden_test: the program that draws is not there; install gjkstep with it, or as \
a part of this project set GJKSTEP_PROGRAM=ON")
  endif()
  string(REGEX REPLACE "/+$" "" arg_EXPECTED "${arg_EXPECTED}")
  cmake_path(ABSOLUTE_PATH arg_EXPECTED NORMALIZE)
  gjkstep_reserve_golden_folders("${arg_NAME}" "${arg_EXPECTED}" folder)
  set(scenes)
  foreach(scene IN LISTS arg_SCENE)
    if(scene MATCHES "[.]json$")
      cmake_path(ABSOLUTE_PATH scene NORMALIZE)
    endif()
    list(APPEND scenes "${scene}")
  endforeach()
  add_test(NAME "${arg_NAME}"
           COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:gjkstep::program>" "-DNAME=${arg_NAME}"
                   "-DSCENES=${scenes}" "-DEXPECTED=${arg_EXPECTED}" "-DFOLDER=${folder}" "-DOPTIONS=${arg_OPTIONS}"
                   "-DBUILD=${CMAKE_BINARY_DIR}" -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/golden_test.cmake")
endfunction()

cmake_policy(POP)
