# What the nested builds have in common. Expects ROOT, WORK, COMPILER, EIGEN, CATCH2 or CATCH2_SOURCE,
# and CHAPTERS, parted by commas.
cmake_minimum_required(VERSION 3.25)

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

# Configures ROOT in WORK by a preset, with the very libraries of the build that tests.
macro(configure preset)
  set(options "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DEigen3_DIR=${EIGEN}" -DTIMESTEP_NESTED_TESTS=OFF)
  if(CATCH2)
    list(APPEND options "-DCatch2_DIR=${CATCH2}")
  else()
    list(APPEND options "-DFETCHCONTENT_SOURCE_DIR_CATCH2=${CATCH2_SOURCE}")
  endif()
  step("configure" "${CMAKE_COMMAND}" --preset ${preset} -S "${ROOT}" -B "${WORK}" ${options} ${ARGN})
endmacro()
