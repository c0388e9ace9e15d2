# What both nested builds begin with. Leaves `sanitize`, the flags of the preset, and `options`, of the generator and Catch2.
# Expects ROOT, WORK, COMPILER, and CATCH2 or CATCH2_SOURCE.

# The sources of engines are tested with in the build around this one; the sanitizers are for our own code.
unset(ENV{TIMESTEP_BOX3D})
unset(ENV{TIMESTEP_JOLT})

# A step that must succeed; the end of what it said goes to `said`.
function(step what)
  message(STATUS "${what}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    string(LENGTH "${output}" length)
    if(length GREATER 6000)
      math(EXPR from "${length} - 6000")
      string(SUBSTRING "${output}" ${from} -1 output)
    endif()
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${what}: ${command}\nexits with ${status}\n${output}")
  endif()
  set(said "${output}" PARENT_SCOPE)
endfunction()

execute_process(COMMAND "${CMAKE_COMMAND}" --preset sanitize -N WORKING_DIRECTORY "${ROOT}"
  OUTPUT_VARIABLE preset)
if(NOT preset MATCHES "CMAKE_CXX_FLAGS_SANITIZE=\"([^\"]+)\"")
  message(FATAL_ERROR "CMakePresets.json: the preset sanitize has no CMAKE_CXX_FLAGS_SANITIZE: ${preset}")
endif()
set(sanitize "${CMAKE_MATCH_1}")

# With these flags mistakes must be found, else all that follows proves nothing.
separate_arguments(flags UNIX_COMMAND "${sanitize}")
file(MAKE_DIRECTORY "${WORK}")
step("canary" "${COMPILER}" ${flags} "${CMAKE_CURRENT_LIST_DIR}/canary.cpp" -o "${WORK}/canary")
step("a canary that is well" "${WORK}/canary" 0)
foreach(mistake 1 2 3 4)
  execute_process(COMMAND "${WORK}/canary" ${mistake} RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    message(FATAL_ERROR "canary.cpp: mistake ${mistake} was not found with ${sanitize}")
  endif()
endforeach()

# The reader's CMake takes make where Ninja is not asked for, and so does this build. A machine that
# was set up by `./course` may have Ninja only.
find_program(MAKE_PROGRAM NAMES make gmake)
if(MAKE_PROGRAM)
  set(options -G "Unix Makefiles" "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}")
else()
  set(options -G Ninja)
endif()
# The very libraries of the build that tests.
if(CATCH2)
  list(APPEND options "-DCatch2_DIR=${CATCH2}")
else()
  list(APPEND options "-DFETCHCONTENT_SOURCE_DIR_CATCH2=${CATCH2_SOURCE}")
endif()
