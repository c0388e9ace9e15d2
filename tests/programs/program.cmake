# What the three test scripts need: to run the chapter's program, to read its --help, and to collect
# what is wrong. Expects PROGRAM and WORK.
cmake_minimum_required(VERSION 3.25)
cmake_policy(SET CMP0007 NEW)

get_filename_component(name "${PROGRAM}" NAME_WE)
string(REGEX REPLACE "_study$" "" name "${name}")  # it calls itself by the chapter's

function(wrong text)
  set_property(GLOBAL APPEND_STRING PROPERTY problems "\n  ${text}")
endfunction()

# A program that works for a minute of a processor's time loops for ever. By the clock it may take much
# longer, for others may be at work on the machine; there the clock only ends what waits for ever.
set(a_minute "ulimit -t 60;")
set(patience 1400)

# Runs the program in WORK with the arguments, at most a minute: sets `status`, `out` and `err`.
macro(run_program)
  if(CMAKE_HOST_WIN32)
    execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${WORK}" TIMEOUT ${patience}
      RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  else()
    execute_process(COMMAND sh -c "${a_minute} exec \"$@\"" sh "${PROGRAM}" ${ARGN}
      WORKING_DIRECTORY "${WORK}" TIMEOUT ${patience}
      RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  endif()
endmacro()

# The same under `limits`, words of the shell that stand before the program's name, and with its
# printed sent to `printed`.
macro(run_limited limits printed)
  execute_process(COMMAND sh -c "${a_minute} ${limits} exec \"$@\" >${printed}" sh "${PROGRAM}" ${ARGN}
    WORKING_DIRECTORY "${WORK}" TIMEOUT ${patience}
    RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
endmacro()

# The last run must have said one line that starts with the program's name and holds `words`, and
# have exited with 2.
function(must_refuse what words)
  string(FIND "${err}" "${words}" place)
  string(REGEX MATCH "^${name}: [^\n]+\n$" whole "${err}")
  if(NOT status EQUAL 2)
    wrong("${what}: the exit status is ${status}, must be 2")
  elseif(NOT whole)
    wrong("${what}: must be answered with one line, but standard error is \"${err}\"")
  elseif(place EQUAL -1)
    wrong("${what}: the line must hold \"${words}\", but is ${err}")
  endif()
endfunction()

# The options in --help, and for each of them `initial_FLAG` and `rule_FLAG`.
macro(read_options)
  run_program(--help)
  if(NOT status EQUAL 0 OR NOT err STREQUAL "")
    wrong("--help: the exit status is ${status}, must be 0; standard error: ${err}")
  endif()
  set(flags "")
  string(REPLACE ";" "@" out "${out}")  # a semicolon would part the list below
  string(REGEX MATCHALL "\n  --[^\n]*" help "${out}")
  foreach(line IN LISTS help)
    if(line MATCHES "^\n  (--[a-z0-9-]+) +[^ ].* \\(([^;()]*)@ must be (.*)\\)$")
      list(APPEND flags "${CMAKE_MATCH_1}")
      set(initial_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
      set(rule_${CMAKE_MATCH_1} "${CMAKE_MATCH_3}")
    elseif(NOT line MATCHES "^\n  (--out DIR|--help) ")
      wrong("--help: a line does not state the option's value and rule: ${line}")
    endif()
  endforeach()
endmacro()

function(report)
  get_property(problems GLOBAL PROPERTY problems)
  if(problems)
    message(FATAL_ERROR "${name}: ${problems}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
