# The exercises are handed out unsolved. What is committed in exercises/ must be what the build makes of
# the solution, or have been so once: then it is a learner who has committed answers, which is fine.
# Expects ROOT, GENERATED.
cmake_minimum_required(VERSION 3.25)

find_program(GIT git)
function(git result)
  execute_process(COMMAND "${GIT}" ${ARGN} WORKING_DIRECTORY "${ROOT}"
    OUTPUT_VARIABLE output ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

if(GIT)
  git(committed ls-files -- exercises)
endif()
if(NOT committed)
  message("skipped: not in a git checkout")
  return()
endif()

set(answered "")  # by a learner
set(wrong "")
file(GLOB rooms RELATIVE "${ROOT}/tests/exercises" "${ROOT}/tests/exercises/*/*/about.json")
foreach(room IN LISTS rooms)
  cmake_path(GET room PARENT_PATH exercise)
  cmake_path(GET exercise FILENAME name)
  git(unsolved hash-object --no-filters "${GENERATED}/${name}_stub.cpp")
  git(now rev-parse --verify --quiet HEAD:./exercises/${exercise}.cpp)
  git(edited status --porcelain -- solutions/${exercise}.cpp)
  if(now STREQUAL "" OR now STREQUAL unsolved OR NOT edited STREQUAL "")
    continue()
  endif()
  # A commit without a parent may be where history was cut off: what was before, nobody knows.
  git(history log --no-abbrev --raw "--format=parents:%P." -- exercises/${exercise}.cpp)
  if(history MATCHES "${unsolved}|parents:[.]")
    list(APPEND answered exercises/${exercise}.cpp)
  else()
    list(APPEND wrong exercises/${exercise}.cpp)
  endif()
endforeach()
list(JOIN wrong ", " where)
if(wrong)
  message(FATAL_ERROR "not what learners should get, and never was: ${where}; that is in\n"
    "${GENERATED}, as NAME_stub.cpp")
endif()
list(JOIN answered ", " where)
if(answered)
  message("skipped: answers are committed in ${where}")
endif()
