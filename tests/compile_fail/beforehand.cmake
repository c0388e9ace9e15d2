# Compiles Eigen for the tests of misuse. Called with COMPILER, EIGEN and READY, the folder to leave it in.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/flags.cmake")

file(MAKE_DIRECTORY "${READY}")
file(WRITE "${header}" "#include <Eigen/Dense>\n")
execute_process(COMMAND ${compile} -x c++-header "${header}" -o "${compiled}"
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
