# One misuse: SOURCE compiles as it is; with -DMISUSE it does not, and the first error is the line
# that SOURCE promises after "// error: ". Called with COMPILER, SOURCE, INCLUDE, EIGEN and READY.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/flags.cmake")

file(STRINGS "${SOURCE}" promise REGEX "^// error: timestep: " ENCODING UTF-8)
string(REPLACE "// error: " "" promise "${promise}")
if(NOT promise)
  message(FATAL_ERROR "${SOURCE}: must promise the message, in a line // error: timestep: …")
endif()
set(compile ${compile} ${use_ready} -fsyntax-only "-I${INCLUDE}" "${SOURCE}")

execute_process(COMMAND ${compile} RESULT_VARIABLE status OUTPUT_VARIABLE output
  ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${SOURCE}: must compile without the misuse, but:\n${output}")
endif()

execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 ${compile} -DMISUSE
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0)
  message(FATAL_ERROR "${SOURCE}: the misuse compiles")
endif()
string(REGEX MATCH "error: [^\n]*" first "${output}")
string(FIND "${first}" "${promise}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${SOURCE}: the first error must say\n  ${promise}\nbut says\n  ${first}\n\n${output}")
endif()
