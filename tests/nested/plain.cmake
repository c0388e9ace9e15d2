# Plain CMake is enough: configure, build, ctest and the target docs, without the course program and on a machine that
# has none of what only the counts of instructions, the other libraries in chapter 7 and the looks of the site need.
# Warnings are errors. And under the address and the undefined-behaviour sanitizer nothing is found in the library's
# and the chapters' tests, nor in any chapter's program as it draws its figures and as it is given bad
# input: these are compiled with the flags of the preset `sanitize`. (The flags leave out checks of every
# pointer, null, alignment, object-size and vptr, which double the time to compile Eigen: the address
# sanitizer stops at a null pointer, Eigen at a misaligned vector, and nothing here is virtual.)
#
# Expects ROOT, WORK, COMPILER, EIGEN, and CATCH2 or CATCH2_SOURCE.
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
step("configure" "${CMAKE_COMMAND}" --preset strict -S "${ROOT}" -B "${WORK}" ${options}
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DEigen3_DIR=${EIGEN}" -DTIMESTEP_NESTED_TESTS=OFF
  "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
  "-DCMAKE_PROJECT_timestep_INCLUDE=${CMAKE_CURRENT_LIST_DIR}/sanitize.cmake" "-DSANITIZE=${sanitize}"
  -DTIMESTEP_COURSE=OFF -DTIMESTEP_WITHOUT=ODEINT,GSL,SUNDIALS,BULLET,ODE -DVALGRIND= -DKATEX= -DAWESOME= -DLUNR=)
foreach(sentence
    "KaTeX not found: formulas stand as TeX source (package libjs-katex)"
    "lunr not found: the search knows names alone (package libjs-lunr)"
    "GSL not found: it is left out of the diagrams (package libgsl-dev)"
    "doxygen-awesome-css not found: Doxygen's own theme (package doxygen-awesome-css)")
  string(FIND "${said}" "${sentence}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "the configuration must say \"${sentence}\", but says\n${said}")
  endif()
endforeach()

step("build and docs" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2 --target all docs)
# An exercise needs it.
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}" --target check_velocity_now OUTPUT_VARIABLE said
  ERROR_QUIET RESULT_VARIABLE status)
if(status EQUAL 0 OR NOT said MATCHES "(^|\n)check_velocity_now needs the course program, which -DTIMESTEP_COURSE=ON builds\n")
  message(FATAL_ERROR "without the course program check_velocity_now exits with ${status} and says\n${said}")
endif()
if(NOT EXISTS "${WORK}/site/html/index.html")
  message(FATAL_ERROR "the target docs left no site/html/index.html")
endif()
# What does not depend on the compiler or on the site's looks has been tested in the build around
# this one.
step("ctest" "${CMAKE_CTEST_COMMAND}" --test-dir "${WORK}" --parallel 2 --output-on-failure
  --no-tests=error --label-exclude "heavy|release" --exclude-regex
  "^(front door|readme:|a chapter|an exercise that|site: (every written page|planted|panels|films|the book|grows|deletions)) |(needs all that it uses|its tests are tested.*|slips of its right answers are caught)$")
message(STATUS "${said}")
