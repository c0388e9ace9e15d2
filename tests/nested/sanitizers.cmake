# The address and the undefined-behaviour sanitizer find nothing in the library's and the chapters' tests, nor in the
# chapters' programs. They are built by the preset `sanitize`; with STRICT a warning is an error.
#
# Expects ROOT, WORK, COMPILER, EIGEN, NAMES (of the programs), and CATCH2 or CATCH2_SOURCE.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

step("configure" "${CMAKE_COMMAND}" --preset sanitize -S "${ROOT}" -B "${WORK}" ${options} "-DTIMESTEP_STRICT=${STRICT}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DEigen3_DIR=${EIGEN}" -DTIMESTEP_WITHOUT=ODEINT,GSL,SUNDIALS,BULLET,ODE)
step("build" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2 --target timestep_tests ${NAMES})
step("timestep_tests" "${WORK}/tests/timestep_tests" "~[proof]")
string(REGEX MATCH "All tests passed[^\n]*" passed "${said}")
message(STATUS "${passed}")
foreach(name IN LISTS NAMES)
  file(MAKE_DIRECTORY "${WORK}/ran/${name}")
  step("${name}" "${CMAKE_COMMAND}" -E chdir "${WORK}/ran/${name}" "${WORK}/chapters/${name}")
endforeach()
