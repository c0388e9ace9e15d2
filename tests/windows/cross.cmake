# The preset `windows`, configured and built in a folder of its own, and what it makes run by wine. Each chapter's program
# leaves its data, the studies' checks hold, the tests of the library, of the chapters and of gyroscopic.h pass, and an
# answer to an exercise is checked. (tests/same_bits compares what is computed with other machines' results.)
#
# Called with ROOT, WORK, NAMES (of the chapters' programs), CATCH2 (its source; may be empty: CMake fetches it) and WINE
# (the folder of its drive).
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
# What counts is how soon it is built; the bits are the same (tests/same_bits).
step("configure" "${CMAKE_COMMAND}" --preset windows -S "${ROOT}" -B "${WORK}" ${source}
  "-DANSWER_velocity_now=${WORK}/answers/velocity_now.cpp" "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG")
step("build" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2 --target all)

# A chapter's program leaves its data, and its study's checks hold: else the study exits with 1.
foreach(name IN LISTS NAMES)
  set(folder "${WORK}/run/${name}")
  file(REMOVE_RECURSE "${folder}")
  file(MAKE_DIRECTORY "${folder}")
  set(run "${CMAKE_COMMAND}" -E chdir "${folder}" "${ROOT}/tests/same_bits/wine.sh")
  step("${name}" ${run} "${WORK}/chapters/${name}.exe")
  file(GLOB data "${folder}/*.dat")
  if(NOT data)
    message(SEND_ERROR "${name}: left no data")
  endif()
  file(GLOB study "${ROOT}/chapters/*_${name}/study/study.cpp")
  if(study)
    step("${name}_study" ${run} "${WORK}/chapters/${name}_study.exe" --out found)
  endif()
endforeach()

foreach(tests tests/timestep_tests engines/tests/c_tests)
  step("${tests}" "${ROOT}/tests/same_bits/wine.sh" "${WORK}/${tests}.exe" "~[proof]")
  string(REGEX MATCH "(All tests passed|test cases:)[^\n]*" passed "${said}")
  message(NOTICE "${tests}: ${passed}")
endforeach()

# An answer that is right, and one that is not.
function(check words pass)
  execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}" --target check_velocity_now
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT said MATCHES "${words}" OR (pass AND NOT status EQUAL 0) OR (NOT pass AND status EQUAL 0))
    message(SEND_ERROR "check_velocity_now exits with ${status} and says\n${said}\nbut must say \"${words}\"")
  endif()
endfunction()
file(READ "${ROOT}/solutions/01_derivatives/velocity_now.cpp" solved)
file(WRITE "${answer}" "${solved}")
check("1[.]1 velocity_now: right" ON)
string(REPLACE "(newer - older)" "(older - newer)" wrong "${solved}")
file(WRITE "${answer}" "${wrong}")
check("1[.]1 velocity_now: not yet.*This must hold, and does not:.*right is " OFF)
string(REPLACE "return newer" "return unheard_of + newer" wrong "${solved}")
file(WRITE "${answer}" "${wrong}")
check("error: .*unheard_of" OFF)
