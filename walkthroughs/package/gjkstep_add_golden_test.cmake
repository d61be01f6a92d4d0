# gjkstep_add_golden_test(NAME name SCENE scene... EXPECTED folder [OPTIONS option...])
#
# A test for CTest that draws scenes and compares their pictures with accepted ones. Call enable_testing() before it.
#
#   NAME      of the test; any text without a semicolon
#   SCENE     scene files, relative to the current source folder, or names that `gjkstep list` shows
#   EXPECTED  folder of the accepted pictures, of this test alone; it need not be there yet. What is no longer drawn is
#             removed from it where new pictures are accepted
#   OPTIONS   for `gjkstep render`, such as --size 640x360 --strip
#
# A test that fails keeps what it drew, and a report, in golden/NAME of the build folder: open report/index.html. To
# accept what is drawn now, the first time or after a change, ask for it, then look at what version control shows:
#
#     GJKSTEP_ACCEPT=1 ctest --test-dir build -R NAME --verbose
cmake_policy(GET CMP0110 gjkstep_any_test_name)  # of who includes this: may names of tests hold spaces?
cmake_policy(PUSH)
cmake_policy(VERSION 3.25)

function(gjkstep_golden_test_error text)
  message(FATAL_ERROR "gjkstep_add_golden_test: ${text}")
endfunction()

# In OUT: whether one of the folders is the other or lies in it.
function(gjkstep_folders_overlap one other out)
  string(FIND "${one}/" "${other}/" at_start)
  string(FIND "${other}/" "${one}/" at_start_of_other)
  if(at_start EQUAL 0 OR at_start_of_other EQUAL 0)
    set(${out} TRUE PARENT_SCOPE)
  else()
    set(${out} FALSE PARENT_SCOPE)
  endif()
endfunction()

# Stops where pictures accepted in `expected` could be lost, or others be lost to them.
function(gjkstep_check_expected name expected)
  foreach(source IN ITEMS "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
    string(FIND "${source}/" "${expected}/" at_start)
    if(at_start EQUAL 0)
      gjkstep_golden_test_error("EXPECTED of '${name}' is ${expected}, which holds your project; name a folder of its own")
    endif()
  endforeach()
  gjkstep_folders_overlap("${expected}" "${CMAKE_BINARY_DIR}/golden" is_lost)
  if(is_lost)
    gjkstep_golden_test_error("EXPECTED of '${name}' is ${expected}, where tests draw anew each time; name a folder \
of your sources")
  endif()
  set(above "${expected}")
  while(NOT EXISTS "${above}")
    cmake_path(GET above PARENT_PATH above)
  endwhile()
  if(NOT IS_DIRECTORY "${above}")
    gjkstep_golden_test_error("EXPECTED of '${name}' is ${expected}, but ${above} is a file; name a folder")
  endif()
endfunction()

# In OUT: the folder of the test, below the build folder. Stops where another test has it, or has accepted pictures above
# or below those expected here.
function(gjkstep_reserve_golden_folders name expected out)
  string(REGEX REPLACE "[^A-Za-z0-9 _+.-]|^[.]+" "_" folder "${name}")
  cmake_path(APPEND CMAKE_BINARY_DIR golden "${folder}" OUTPUT_VARIABLE folder)
  foreach(path IN ITEMS "${folder}" "${expected}")
    string(REPLACE ";" "?" path "${path}")  # or it would be two of the list
    get_property(others GLOBAL PROPERTY gjkstep_golden_folders)
    foreach(other IN LISTS others)
      gjkstep_folders_overlap("${path}" "${other}" is_shared)
      if(is_shared)
        get_property(owner GLOBAL PROPERTY "gjkstep golden ${other}")
        gjkstep_golden_test_error("'${name}' and '${owner}' share the folder ${path}; each test needs a name and an \
EXPECTED of its own, none within another's")
      endif()
    endforeach()
    set_property(GLOBAL APPEND PROPERTY gjkstep_golden_folders "${path}")
    set_property(GLOBAL PROPERTY "gjkstep golden ${path}" "${name}")
  endforeach()
  set(${out} "${folder}" PARENT_SCOPE)
endfunction()

# At the end of a folder's CMakeLists.txt: enable_testing() may come after the tests.
function(gjkstep_expect_testing)
  if(NOT CMAKE_TESTING_ENABLED)
    message(WARNING "gjkstep_add_golden_test: ctest will run none of the tests of ${CMAKE_CURRENT_SOURCE_DIR}; call \
enable_testing() in the CMakeLists.txt on top")
  endif()
endfunction()

function(gjkstep_add_golden_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;EXPECTED" "SCENE;OPTIONS")
  foreach(needed IN ITEMS NAME SCENE EXPECTED)
    if("${arg_${needed}}" STREQUAL "")
      gjkstep_golden_test_error("${needed} is missing; expected NAME name SCENE scene... \
EXPECTED folder [OPTIONS option...]")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS OR arg_NAME MATCHES ";")
    gjkstep_golden_test_error("'${arg_UNPARSED_ARGUMENTS}' is not expected in '${arg_NAME}', \
nor a semicolon in a name")
  endif()
  if(DEFINED gjkstep_any_test_name AND NOT gjkstep_any_test_name STREQUAL "NEW" AND arg_NAME MATCHES "[^A-Za-z0-9_.+-]")
    gjkstep_golden_test_error("'${arg_NAME}' has more than letters, digits and _.+-, which takes \
cmake_minimum_required(VERSION 3.19) or newer")
  endif()
  if(NOT TARGET gjkstep::program)
    gjkstep_golden_test_error("the program that draws is not there; install gjkstep with it, or as \
a part of this project set GJKSTEP_PROGRAM=ON")
  endif()
  cmake_path(ABSOLUTE_PATH arg_EXPECTED NORMALIZE)
  string(REGEX REPLACE "/+$" "" arg_EXPECTED "${arg_EXPECTED}")
  gjkstep_check_expected("${arg_NAME}" "${arg_EXPECTED}")
  gjkstep_reserve_golden_folders("${arg_NAME}" "${arg_EXPECTED}" folder)
  cmake_language(DEFER GET_CALL gjkstep_expect_testing looked_for)
  if(NOT looked_for)
    cmake_language(DEFER ID gjkstep_expect_testing CALL gjkstep_expect_testing)
  endif()
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
