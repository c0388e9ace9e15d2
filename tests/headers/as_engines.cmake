# Engines compile what they include by their own rules. All headers in one program that uses them:
# - C++20, and every warning that an engine may have on is an error;
# - C++23 without exceptions and run-time types. What is refused then ends the program with its line, or is handed
#   to the engine's own function;
# - -ffast-math is refused by one line, by gyroscopic.h as by the other headers;
# - gyroscopic.h as C99, C17 and C++11.
# Called with COMPILER, CC (a C compiler), ROOT, EIGEN and WORK.
cmake_minimum_required(VERSION 3.25)

set(here "${CMAKE_CURRENT_LIST_DIR}")
set(include "${ROOT}/include")
file(GLOB_RECURSE headers RELATIVE "${include}" "${include}/*.hpp")
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>")
list(JOIN headers "\n" all)
file(WRITE "${WORK}/all.cpp" "${all}\n#include \"${here}/as_engines.cpp\"\n")
set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion -Werror "-I${include}")
set(compile "${COMPILER}" ${warnings} -ffp-contract=off -isystem "${EIGEN}")

function(must_succeed)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(SEND_ERROR "${command}\n${output}")
  endif()
endfunction()
# What the program says on its standard error when it ends with a mass of minus one.
function(must_refuse program says)
  execute_process(COMMAND "${program}" refuse RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE line)
  if(status EQUAL 0 OR NOT line STREQUAL "${says}\n")
    message(SEND_ERROR "${program}: must end with\n${says}\nbut ends with ${status} and\n${line}")
  endif()
endfunction()
function(must_refuse_fast_math)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 ${ARGN} -ffast-math -fsyntax-only
    RESULT_VARIABLE status ERROR_VARIABLE output)
  string(REGEX MATCHALL "error: [^\n]*" errors "${output}")
  if(status EQUAL 0 OR NOT errors MATCHES "^error: [#\"a-z ]*timestep: not with -ffast-math[^;]*$")
    message(SEND_ERROR "${ARGN} -ffast-math: one line must refuse it, but:\n${errors}")
  endif()
endfunction()

must_succeed(${compile} -std=c++20 -fsyntax-only "${WORK}/all.cpp")
set(bare ${compile} -std=c++2b -fno-exceptions -fno-rtti)
must_succeed(${bare} "${WORK}/all.cpp" -o "${WORK}/bare")
must_refuse("${WORK}/bare" "timestep: mass = -1: must be finite and greater than zero")
must_succeed(${bare} "-DTIMESTEP_REFUSED(line)=(std::fprintf(stderr, \"engine: %s\\n\", line), std::exit(3))"
  -DONLY_REFUSE "${here}/as_engines.cpp" -o "${WORK}/hook")
must_refuse("${WORK}/hook" "engine: mass = -1: must be finite and greater than zero")

set(calls "${ROOT}/engines/tests/calls.c")
must_refuse_fast_math(${compile} -std=c++20 -include timestep/rigid/shapes.hpp -x c++ /dev/null)
must_refuse_fast_math(${compile} -std=c++11 -x c++ "${calls}")
must_refuse_fast_math("${CC}" -std=c99 "-I${include}" "${calls}")
must_succeed("${CC}" -std=c17 ${warnings} -fsyntax-only "${calls}")
foreach(level -O0 -O1 -O2 -O3 -Os)  # what must be inlined has to be inlined by all of them
  must_succeed("${CC}" -std=c99 ${warnings} -Wfloat-conversion ${level} -c "${calls}" -o "${WORK}/calls.o")
  must_succeed(${compile} -std=c++11 -Wold-style-cast -x c++ ${level} -c "${calls}" -o "${WORK}/calls.o")
endforeach()
