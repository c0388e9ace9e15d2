# A run whose figures are not those that about.json names fails, says so, and leaves the figures of
# the run before. Called with ROOT, GNUPLOT and WORK.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}/study")
file(WRITE "${WORK}/about.json" "{\"picture\": \"one.svg\", \"figures\": [\"one.svg\", \"two.gif\"]}")
file(WRITE "${WORK}/figures.gp" "load style\n")  # here the study draws all

find_program(small true REQUIRED)

# A chapter's study that leaves what its chapter needs.
function(program body)
  file(WRITE "${WORK}/program" "#!/bin/sh\n# program --out DIR\n${body}\n")
  file(CHMOD "${WORK}/program" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()
set(good_program "printf 't\\tx\\n0\\t1\\n1\\t2\\n' >\"$2/data.tsv\"; echo 'all is well'")

set(still "call figure 'one.svg' 400 300\nplot 'data.tsv' using 1:2 with lines\n")
set(film "set terminal gif size 300,200\nset output 'two.gif'\nplot 'data.tsv' using 1:2\nunset output\n")
function(draw)
  string(CONCAT text "load style\n" ${ARGN})
  file(WRITE "${WORK}/study/figures.gp" "${text}")
endfunction()

macro(run_chapter)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=${small}" "-DSTUDY=${WORK}/program"
            "-DOUT=${WORK}/run" -DQUIET=ON "-DROOM=${WORK}" "-DSTYLE=${ROOT}/tools/figures/style.gp"
            "-DGNUPLOT=${GNUPLOT}" ${misuse} -P "${ROOT}/tools/cmake/run.cmake"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
endmacro()

function(state result)
  file(GLOB_RECURSE files RELATIVE "${WORK}/run" "${WORK}/run/*" "${WORK}/run/.*")
  set(list "")
  foreach(file IN LISTS files)
    file(SHA256 "${WORK}/run/${file}" hash)
    list(APPEND list "${file} ${hash}")
  endforeach()
  set(${result} "${list}" PARENT_SCOPE)
endfunction()

program("${good_program}")
draw("${still}" "${film}")
run_chapter()
if(NOT status EQUAL 0)
  message(FATAL_ERROR "a run with all its figures must succeed, but: ${output}")
endif()
foreach(file data.tsv one.svg narrow/one.svg two.gif run.txt seconds.txt done)
  if(NOT EXISTS "${WORK}/run/${file}")
    message(SEND_ERROR "a run with all its figures: ${file} is missing")
  endif()
endforeach()
state(good)

function(must_fail words)
  run_chapter()
  string(FIND "${output}" "${words}" place)
  if(status EQUAL 0 OR place EQUAL -1)
    message(SEND_ERROR "must fail and say \"${words}\", but exits with ${status}: ${output}")
  endif()
  state(now)
  if(NOT now STREQUAL good)
    message(SEND_ERROR "${words}: the run before was\n${good}\nand is now\n${now}")
  endif()
endfunction()

draw("${still}")
must_fail("figure two.gif was not drawn by figures.gp")
draw("${still}" "${film}" "call figure 'three.svg' 400 300\nplot 'data.tsv' using 1:2\n")
must_fail("figures.gp draws three.svg, which is not in the list of figures")
draw("${still}" "${film}" "plot ;\n")
must_fail("figures.gp: gnuplot says:")
draw("${still}" "${film}" "call figure 'one.svg' 400 300\nset xrange [0:1]\nset yrange [0:1]\n"
     "plot 'data.tsv' using 7:8\n")  # columns that are not there
must_fail("figures.gp: gnuplot says:")
draw("${still}" "${film}" "set output\nsystem(\"printf '<svg>' >one.svg\")\n")
must_fail("one.svg: was not written to its end")
draw("${still}" "${film}")
program("${good_program}\necho 'small: does not hold: it grows' >&2\nexit 1")
must_fail("small: does not hold: it grows")
program("${good_program}\nkill -9 $$")
must_fail("program: ")

# What the compiler says of a source that must not compile; the compiler is played by a script.
program("${good_program}")
function(compiler body)
  file(WRITE "${WORK}/cxx" "#!/bin/sh\n${body}\n")
  file(CHMOD "${WORK}/cxx" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()
set(misuse -DMISUSES=rooms/wrong.cpp "-DROOT=${WORK}" "-DCOMPILER=${WORK}/cxx")
compiler("exit 0")
must_fail("rooms/wrong.cpp: compiles, and must not")
compiler("echo 'rooms/wrong.cpp:1: error: no such file' >&2; exit 1")
must_fail("rooms/wrong.cpp: does not compile, but for another reason: ")
set(command "$ cxx -std=c++20 -fsyntax-only -Iinclude rooms/wrong.cpp")
set(gnu "rooms/wrong.cpp:9:18:   required from here\na.hpp:6:19: error: static assertion failed: timestep: no")
set(clang "a.hpp:6:5: error: static_assert failed \"timestep: no\"\nrooms/wrong.cpp:9:15: note: f requested here")
foreach(said IN ITEMS "${gnu}" "${clang}")
  compiler("cat >&2 <<'END'\nIn file included from rooms/wrong.cpp:2:\n${said}\nmore\nEND\nexit 1")
  run_chapter()
  file(READ "${WORK}/run/wrong.txt" written)
  if(NOT status EQUAL 0 OR NOT written STREQUAL "${command}\n${said}\n")
    message(SEND_ERROR "a misuse: the page would show\n${written}\nand must show\n${command}\n${said}\n${output}")
  endif()
endforeach()
