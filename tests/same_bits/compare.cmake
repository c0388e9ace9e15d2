# Compiles the table of bits with COMPILE, runs it with RUN before its name, and holds what it prints to golden.txt.
# Called with COMPILE, RUN, INCLUDE, EIGEN and WORK.
cmake_minimum_required(VERSION 3.25)

set(golden "${CMAKE_CURRENT_LIST_DIR}/golden.txt")
set(program "${WORK}/bits.exe")
file(MAKE_DIRECTORY "${WORK}")
list(JOIN COMPILE " " desk)

execute_process(
  COMMAND ${COMPILE} -std=c++20 -ffp-contract=off "-I${INCLUDE}" -isystem "${EIGEN}"
          "${CMAKE_CURRENT_LIST_DIR}/bits.cpp" -o "${program}"
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${desk}: the table does not compile:\n${output}")
endif()
execute_process(COMMAND ${RUN} "${program}" OUTPUT_FILE "${WORK}/table.txt" RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${desk}: the table exits with ${status}: ${error}")
endif()

execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files --ignore-eol "${WORK}/table.txt" "${golden}"
  RESULT_VARIABLE differs)
if(differs)
  file(READ "${WORK}/table.txt" found)
  message(FATAL_ERROR "${desk}: other bits than in ${golden}:\n${found}This table becomes the new golden.txt only where a "
    "method or a scene is new or was changed on purpose. ${program} scenes prints each scene's bits.")
endif()
