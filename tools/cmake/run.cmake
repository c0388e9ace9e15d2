# Runs one chapter: its program, then gnuplot on what the program left. Called as
#   cmake -DPROGRAM=… -DOUT=… -DSCRIPT=figures.gp -DSTYLE=style.gp -DGNUPLOT=… -DABOUT=about.json
#         [-DQUIET=ON] [-DARGUMENTS=--omega;2] -P run.cmake
# Leaves in OUT: the data (*.tsv), numbers.tsv, checks.tsv, the account (run.txt), seconds.txt and
# the figures. All of it is made in a folder of its own and moved in when it is whole.

cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/chapter_figures.cmake")

function(fail text)
  file(REMOVE_RECURSE "${work}")
  message(FATAL_ERROR "${text}")
endfunction()

set(work "${OUT}/.unfinished_run")
file(REMOVE_RECURSE "${work}")
file(MAKE_DIRECTORY "${work}")

string(TIMESTAMP begin "%s%f")
execute_process(COMMAND "${PROGRAM}" ${ARGUMENTS} --out "${work}"
  OUTPUT_VARIABLE account ERROR_VARIABLE complaint RESULT_VARIABLE status)
string(TIMESTAMP end "%s%f")
if(NOT status EQUAL 0)
  fail("${complaint}")
endif()
if(NOT QUIET)
  message(NOTICE "${account}")
endif()
file(WRITE "${work}/run.txt" "${account}")
math(EXPR milliseconds "(${end} - ${begin}) / 1000")
file(WRITE "${work}/seconds.txt" "${milliseconds} ms\n")

execute_process(COMMAND "${GNUPLOT}" -e "style = '${STYLE}'" "${SCRIPT}"
  WORKING_DIRECTORY "${work}" ERROR_VARIABLE complaint OUTPUT_VARIABLE complaint
  RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT complaint STREQUAL "")
  fail("${SCRIPT}: gnuplot says:\n${complaint}")
endif()
check_figures("${work}" "${ABOUT}" problem)
if(problem)
  fail("${problem}")
endif()

file(GLOB old "${OUT}/*.tsv" "${OUT}/*.svg" "${OUT}/*.gif")
if(old)
  file(REMOVE ${old})
endif()
file(GLOB made "${work}/*")
file(COPY ${made} DESTINATION "${OUT}")
file(REMOVE_RECURSE "${work}")
file(TOUCH "${OUT}/done")
