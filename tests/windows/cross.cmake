# The preset `windows`, configured and built in a folder of its own, and what it makes run by wine. A chapter's program
# prints the same account and writes the same data as here, a panel draws the same picture, the studies find the same
# numbers, the tests of the library, of the chapters and of gyroscopic.h pass, and an answer to an exercise is checked.
#
# Called with ROOT, WORK, HERE (where this build has the chapters' programs), NAMES (of those), STUDIES (of them, those
# that are compared), CATCH2 (its source; may be empty: CMake fetches it) and WINE (the folder of its drive).
cmake_minimum_required(VERSION 3.25)
set(ENV{TIMESTEP_WINE} "${WINE}")

# Runs a step. Where it fails, the end of what it said is told.
function(step what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    if(said MATCHES "[Dd]ownload.*Catch2|Catch2.*[Dd]ownload")
      message(FATAL_ERROR "skipped: Catch2's source is not here and could not be fetched")
    endif()
    string(LENGTH "${said}" length)
    math(EXPR from "${length} - 6000")
    if(from GREATER 0)
      string(SUBSTRING "${said}" ${from} -1 said)
    endif()
    message(FATAL_ERROR "${what} exits with ${status}:\n${said}")
  endif()
endfunction()

set(source "")
if(CATCH2)
  set(source "-DFETCHCONTENT_SOURCE_DIR_CATCH2=${CATCH2}")
endif()
set(answer "${WORK}/answers/velocity_now.cpp")
configure_file("${ROOT}/exercises/01_derivatives/velocity_now.cpp" "${answer}" COPYONLY)
# What counts is how soon it is built; the bits are the same (tests/bits).
step("configure" "${CMAKE_COMMAND}" --preset windows -S "${ROOT}" -B "${WORK}" ${source}
  "-DANSWER_velocity_now=${WORK}/answers/velocity_now.cpp" "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG")
set(targets ${NAMES} live_programs timestep_tests c_tests)
foreach(name IN LISTS STUDIES)  # the others build, too, and take their time
  list(APPEND targets ${name}_study)
endforeach()
step("build" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2 --target ${targets})

# Runs a program, here or there (on Windows). What it prints, printed.txt, and the files that it leaves are in
# ${WORK}/${where}/${name} then.
file(REMOVE_RECURSE "${WORK}/here" "${WORK}/there")
function(run where name)
  set(folder "${WORK}/${where}/${name}")
  file(MAKE_DIRECTORY "${folder}")
  set(command "${HERE}/${name}")
  if(where STREQUAL "there")
    set(command "${ROOT}/tests/bits/wine.sh" "${WORK}/chapters/${name}.exe")
  endif()
  execute_process(COMMAND ${command} ${ARGN} WORKING_DIRECTORY "${folder}" RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${name} ${where} exits with ${status}: ${err}")
  endif()
  file(WRITE "${folder}/printed.txt" "${out}")
endfunction()

# The file must be the same here and there, but for how a line ends. `without`, a regular expression, is left out: what
# is measured with a clock, or differs from one compiler to the next as the page says.
function(compare name file without)
  foreach(where here there)
    file(READ "${WORK}/${where}/${name}/${file}" ${where})
    string(REPLACE "\r\n" "\n" ${where} "${${where}}")
    if(without)
      string(REGEX REPLACE "${without}" "\n" ${where} "${${where}}")
    endif()
  endforeach()
  if(here STREQUAL "" OR NOT here STREQUAL there)
    message(SEND_ERROR "${name}: ${file} is not the same: ${WORK}/here/${name}/${file} and ${WORK}/there/${name}/${file}")
  endif()
endfunction()

foreach(name IN LISTS NAMES)
  run(here ${name})
  run(there ${name})
  file(GLOB data RELATIVE "${WORK}/here/${name}" "${WORK}/here/${name}/*.dat")
  if(NOT data)
    message(SEND_ERROR "${name}: left no data")
  endif()
  foreach(file IN LISTS data ITEMS printed.txt)
    set(clock "")
    if(name STREQUAL "error_against_run_time")
      set(clock " +[0-9.e+-]+\n")
      if(file MATCHES "[.]dat$")
        set(clock "\n[0-9.e+-]+ ")
      endif()
    endif()
    compare(${name} ${file} "${clock}")
  endforeach()
endforeach()

foreach(name IN LISTS STUDIES)
  run(here ${name}_study --out found)
  run(there ${name}_study --out found)
  run(there ${name}_study --out found)  # over what the first has left
  compare(${name}_study found/numbers.tsv "\nbits_[^\n]*")  # chapter 2: two builds of one program
  compare(${name}_study found/checks.tsv "")
endforeach()

file(GLOB panels "${ROOT}/chapters/*/live/*.cpp")
foreach(panel IN LISTS panels)
  cmake_path(GET panel STEM name)
  file(STRINGS "${panel}" words REGEX "^// still: ")
  string(REGEX REPLACE "^// still: " "" words "${words}")
  separate_arguments(words UNIX_COMMAND "${words}")
  list(PREPEND words clock=2)  # what measures sees no other clock
  run(there live_${name} ${words} --still picture.svg)
  run(here live_${name} ${words} --still picture.svg)
  compare(live_${name} picture.svg "")
  compare(live_${name} printed.txt "")
endforeach()

foreach(tests timestep_tests c/c_tests)
  step("${tests}" "${ROOT}/tests/bits/wine.sh" "${WORK}/tests/${tests}.exe" "~[proof]")
  string(REGEX MATCH "(All tests passed|test cases:)[^\n]*" passed "${said}")
  message(NOTICE "${tests}: ${passed}")
endforeach()

# An answer that is not there, one that is right, and some that are not: an editor finds the line, as the problem matcher
# of .vscode reads it.
file(READ "${ROOT}/.vscode/tasks.json" tasks)
string(JSON marked GET "${tasks}" tasks 0 problemMatcher pattern regexp)
string(REGEX REPLACE "^\\^(.*)[$]$" "\n\\1" marked "${marked}")
string(REPLACE ":]" ":\n]" marked "${marked}")  # it reads line by line
function(check words pass)
  execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}" --target check_velocity_now
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT said MATCHES "${words}" OR (pass AND NOT status EQUAL 0) OR (NOT pass AND status EQUAL 0))
    message(SEND_ERROR "check_velocity_now exits with ${status} and says\n${said}\nbut must say \"${words}\"")
  endif()
  if(NOT pass AND NOT words MATCHES "not started")
    if(NOT said MATCHES "${marked}" OR NOT CMAKE_MATCH_1 MATCHES "[/\\\\]velocity_now[.]cpp$")
      message(SEND_ERROR "check_velocity_now marks no line of the answer:\n${said}")
    endif()
  endif()
endfunction()
check("1[.]1 velocity_now: not started" OFF)
file(READ "${ROOT}/solutions/01_derivatives/velocity_now.cpp" solved)
file(WRITE "${answer}" "${solved}")
check("1[.]1 velocity_now: right" ON)
string(REPLACE "(newer - older)" "(older - newer)" wrong "${solved}")
file(WRITE "${answer}" "${wrong}")
check("1[.]1 velocity_now: not yet.*This must hold, and does not:.*right is " OFF)
string(REPLACE "return newer" "throw std::runtime_error(\"no idea\"); return newer" wrong "${solved}")
file(WRITE "${answer}" "${wrong}")
check("1[.]1 velocity_now: crashes.*no idea" OFF)
string(REPLACE "return newer" "return unheard_of + newer" wrong "${solved}")
file(WRITE "${answer}" "${wrong}")
check("error: .*unheard_of" OFF)
