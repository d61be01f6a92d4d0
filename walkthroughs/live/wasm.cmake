# The program that runs in pages: the same sources, compiled by Clang to WebAssembly. Debian 12 has the wasm parts of
# Clang 16, Debian 13 of 19.
set(GJKSTEP_WASM)
if(NOT GJKSTEP_LIVE)
  return()
endif()
find_program(GJKSTEP_WASM_OPT wasm-opt)  # of the package binaryen
foreach(version 19 16)
  find_program(GJKSTEP_WASM_CXX clang++-${version})
  find_program(GJKSTEP_WASM_LD wasm-ld-${version})
  set(wasm_llvm /usr/lib/llvm-${version})
  set(wasm_cxx_headers ${wasm_llvm}/include/wasm32-wasi/c++/v1)
  set(wasm_libraries ${wasm_llvm}/lib/wasm32-wasi)
  file(GLOB wasm_builtins ${wasm_llvm}/lib/clang/${version}/lib/wasi/libclang_rt.builtins-wasm32.a)
  if(GJKSTEP_WASM_CXX AND GJKSTEP_WASM_LD AND EXISTS ${wasm_libraries}/libc++.a AND wasm_builtins)
    set(wasm_version ${version})
    break()
  endif()
  unset(GJKSTEP_WASM_CXX CACHE)
  unset(GJKSTEP_WASM_LD CACHE)
endforeach()
if(NOT wasm_version)
  message(STATUS "Pages are not live, their pictures cannot be taken hold of: no Clang for wasm32. Debian 12: apt-get install \
clang-16 lld-16 wasi-libc libc++-16-dev-wasm32 libc++abi-16-dev-wasm32 libclang-rt-16-dev-wasm32; Debian 13: those of 19")
  return()
endif()
message(STATUS "Pages are live, by Clang ${wasm_version}")

set(wasm_flags --target=wasm32-wasi -std=c++20 -Os -DNDEBUG -ffp-contract=off -fexceptions -ffunction-sections -fdata-sections
               -nostdinc++ -isystem ${wasm_cxx_headers} -D_LIBCPP_ENABLE_CXX17_REMOVED_FEATURES -DJSON_HAS_FILESYSTEM=0
               -DJSON_HAS_EXPERIMENTAL_FILESYSTEM=0 -DBOOST_DISABLE_THREADS -DBOOST_SP_DISABLE_THREADS -DBOOST_LEXICAL_CAST_ASSUME_C_LOCALE -D_WASI_EMULATED_SIGNAL
               -ffile-prefix-map=${PROJECT_BINARY_DIR}/= -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=
               -I${PROJECT_SOURCE_DIR} -I${PROJECT_BINARY_DIR}/include)
# Headers without a library, from where this system has them: not all of /usr/include, which is this system's own C library.
set(wasm_headers ${PROJECT_BINARY_DIR}/wasm/include)
file(MAKE_DIRECTORY ${wasm_headers})
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
find_path(GJKSTEP_JSON_DIR nlohmann/json.hpp REQUIRED)
find_path(GJKSTEP_BOOST_DIR boost/version.hpp REQUIRED)
file(CREATE_LINK ${GJKSTEP_JSON_DIR}/nlohmann ${wasm_headers}/nlohmann SYMBOLIC)
file(CREATE_LINK ${GJKSTEP_BOOST_DIR}/boost ${wasm_headers}/boost SYMBOLIC)
foreach(folder IN LISTS eigen)
  list(APPEND wasm_flags -isystem ${folder})
endforeach()
list(APPEND wasm_flags -isystem ${wasm_headers})

# Compiled as for this system, the small files of a room as one.
# Two programs: what pages load first has the usual searches, the other one has all, and is loaded when a reader asks for it.
set(wasm_objects)
function(compile_for_pages output source)
  add_custom_command(OUTPUT ${output} DEPENDS ${source} ${precompiled} DEPFILE ${output}.d VERBATIM
                     COMMAND ${GJKSTEP_WASM_CXX} ${wasm_flags} -MD -MF ${output}.d -MT ${output} ${ARGN} ${source} -o ${output})
endfunction()
function(add_wasm_object name source)
  set(object ${PROJECT_BINARY_DIR}/wasm/${name}.o)
  if(name MATCHES "^(render|live-wasm|font_tables)")  # other options, or little to read
    set(headers -include ${wasm_sources}/pairs_of_doubles.hpp)
  else()
    set(precompiled ${PROJECT_BINARY_DIR}/wasm/precompiled.pch)
    set(headers -include-pch ${precompiled})
  endif()
  compile_for_pages(${object} ${source} ${headers} ${ARGN} -c)
  list(APPEND wasm_objects ${object})
  set(wasm_objects ${wasm_objects} PARENT_SCOPE)
endfunction()
set(wasm_sources ${CMAKE_CURRENT_LIST_DIR}/wasm)
compile_for_pages(${PROJECT_BINARY_DIR}/wasm/precompiled.pch ${wasm_sources}/precompiled.hpp -x c++-header)
foreach(room model wrong_on_purpose story text picture trace catalogue page live live/wasm render render/live)
  set(folder walkthroughs/${room})
  if(room MATCHES "^render")
    set(folder ${room})
  endif()
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.cpp)
  if(room STREQUAL "render")  # but for what makes pixels and files
    list(FILTER files INCLUDE REGEX "/(canvas|camera|geometry|panel|svg_text|html|font)[.]cpp$")
  endif()
  list(FILTER files EXCLUDE REGEX "/(text_file|document_line|page_programs|trace_schema|write_traces|write_font_table)[.]cpp$")  # files; what no page asks for
  string(REPLACE "/" "-" name ${room})
  set(how)
  if(room MATCHES "^(catalogue|text|trace|page)$")  # asked once, or for a part of a millisecond
    set(how -Oz)
  elseif(room STREQUAL "render")  # places labels, which takes a quarter of the time
    set(how -O2)
  endif()
  set(together "")
  foreach(file IN LISTS files)
    cmake_path(GET file STEM stem)
    if(stem STREQUAL "run")  # of all searches: what is asked for seldom
      add_wasm_object(${name}-run ${file} -Oz)
    elseif(stem IN_LIST apart OR room MATCHES "/")
      add_wasm_object(${name}-${stem} ${file} ${how})
    else()
      string(APPEND together "#include \"${file}\"\n")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/wasm/${name}.cpp CONTENT "${together}")
  add_wasm_object(${name} ${PROJECT_BINARY_DIR}/wasm/${name}.cpp ${how})
endforeach()

add_wasm_object(font_tables ${PROJECT_BINARY_DIR}/font_tables.cpp)

set(of_all_searches ${wasm_objects})
list(FILTER wasm_objects EXCLUDE REGEX "/(model-run|live-trace_reader)[.]o$")
add_wasm_object(few-run ${PROJECT_SOURCE_DIR}/walkthroughs/model/run.cpp -DGJKSTEP_FEW_SEARCHES)
add_wasm_object(few-trace_reader ${PROJECT_SOURCE_DIR}/walkthroughs/live/trace_reader.cpp -DGJKSTEP_FEW_SEARCHES)
set(of_few_searches ${wasm_objects})

add_executable(write-script EXCLUDE_FROM_ALL walkthroughs/live/script/write_script.cpp)
target_link_libraries(write-script PRIVATE render PkgConfig::DEFLATE)
set(GJKSTEP_WASM)  # and the script of each, which pages load
set(name_of_few gjkstepProgram)
set(script_of_few program)
set(name_of_all gjkstepAllSearches)
set(script_of_all all-searches)
foreach(searches few all)
  set(wasm ${PROJECT_BINARY_DIR}/${searches}-searches.wasm)
  set(optimize)
  if(GJKSTEP_WASM_OPT)  # a sixth smaller
    set(optimize COMMAND ${GJKSTEP_WASM_OPT} -Os --enable-bulk-memory --enable-mutable-globals --enable-nontrapping-float-to-int
                         --enable-sign-ext ${wasm} -o ${wasm})
  endif()
  add_custom_command(OUTPUT ${wasm} DEPENDS ${of_${searches}_searches} VERBATIM
    COMMAND ${GJKSTEP_WASM_LD} -L/usr/lib/wasm32-wasi -L${wasm_libraries} --gc-sections --strip-all -O2 --entry _initialize
            -z stack-size=1048576 /usr/lib/wasm32-wasi/crt1-reactor.o ${of_${searches}_searches} -lc++ -lc++abi -lc
            -lwasi-emulated-signal ${wasm_builtins} -o ${wasm}
    ${optimize})
  set(script ${PROJECT_BINARY_DIR}/${script_of_${searches}}.js)
  add_custom_command(OUTPUT ${script} DEPENDS write-script ${wasm} VERBATIM
                     COMMAND write-script ${name_of_${searches}} ${wasm} ${script})
  list(APPEND GJKSTEP_WASM ${script})
endforeach()
