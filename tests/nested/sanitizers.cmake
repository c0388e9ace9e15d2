# The library's and the chapters' tests, and every chapter's program, under the address and the
# undefined-behaviour sanitizer. Left out are checks of every pointer (null, alignment, object-size, vptr), which
# double the time to compile Eigen: the address sanitizer stops at a null pointer, Eigen at a misaligned vector,
# and nothing here is virtual.
include("${CMAKE_CURRENT_LIST_DIR}/nested.cmake")

set(generator "")
find_program(NINJA NAMES ninja ninja-build)
if(NINJA)
  set(generator -G Ninja)
endif()
configure(sanitize ${generator})

string(REPLACE "," ";" programs "${CHAPTERS}")
list(TRANSFORM programs REPLACE "^[0-9]+_" "")
step("build" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2 --target timestep_tests ${programs})

# With these flags mistakes must be found, else all that follows proves nothing.
load_cache("${WORK}" READ_WITH_PREFIX "" CMAKE_CXX_FLAGS_SANITIZE)
separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS_SANITIZE}")
step("canary" "${COMPILER}" ${flags} "${CMAKE_CURRENT_LIST_DIR}/canary.cpp" -o "${WORK}/canary")
step("a canary that is well" "${WORK}/canary" 0)
foreach(mistake 1 2 3 4)
  execute_process(COMMAND "${WORK}/canary" ${mistake} RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    message(FATAL_ERROR "canary.cpp: mistake ${mistake} was not found with ${CMAKE_CXX_FLAGS_SANITIZE}")
  endif()
endforeach()

# Those tagged [long] go over millions of bodies or steps; what they run is run by others, too.
step("tests" "${WORK}/tests/timestep_tests" "~[long]")
foreach(program IN LISTS programs)
  step("${program}" "${WORK}/chapters/${program}" --out "${WORK}/runs/${program}")
endforeach()
step("bad options" "${CMAKE_CTEST_COMMAND}" --test-dir "${WORK}" --parallel 2 --output-on-failure
  --no-tests=error --tests-regex "^program .* refuses bad input$")
