# Compiles hash.cpp with COMPILER, without optimisation, with all of it, and with what this very
# processor can do, and holds what it prints to golden.txt. Called with COMPILER, INCLUDE and WORK.
cmake_minimum_required(VERSION 3.25)

set(source "${CMAKE_CURRENT_LIST_DIR}/hash.cpp")
set(golden "${CMAKE_CURRENT_LIST_DIR}/golden.txt")
file(MAKE_DIRECTORY "${WORK}")
file(STRINGS "${golden}" expected)

set(levels "-O0" "-O3")
cmake_host_system_information(RESULT processor QUERY OS_PLATFORM)
if(processor MATCHES "x86_64|AMD64")
  list(APPEND levels "-O3 -march=native")  # fused multiply-add must not creep in
endif()

foreach(level IN LISTS levels)
  separate_arguments(flags UNIX_COMMAND "${level}")
  execute_process(
    COMMAND "${COMPILER}" -std=c++20 -ffp-contract=off ${flags} "-I${INCLUDE}" "${source}" -o "${WORK}/hash"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${COMPILER} ${level}: hash.cpp does not compile:\n${output}")
  endif()
  execute_process(COMMAND "${WORK}/hash" RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE error)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${COMPILER} ${level}: hash exits with ${status}: ${error}")
  endif()

  file(WRITE "${WORK}/hashes.txt" "${output}")
  file(STRINGS "${WORK}/hashes.txt" found)
  if(NOT found STREQUAL expected)
    set(only_found ${found})
    set(only_expected ${expected})
    list(REMOVE_ITEM only_found ${expected})
    list(REMOVE_ITEM only_expected ${found})
    list(JOIN only_found "\n  " only_found)
    list(JOIN only_expected "\n  " only_expected)
    message(FATAL_ERROR
      "${COMPILER} ${level}: other bits than in ${golden}\nfound:\n  ${only_found}\n"
      "expected:\n  ${only_expected}\nall that was found is in ${WORK}/hashes.txt. It becomes the "
      "new golden.txt only where a method or a scene is new or was changed on purpose.")
  endif()
endforeach()

# No method is left out.
file(GLOB headers "${INCLUDE}/timestep/methods/*.hpp")
foreach(header IN LISTS headers)
  file(READ "${header}" text)
  if(text MATCHES "static constexpr const char\\* name = \"([^\"]*)\"")
    set(name "${CMAKE_MATCH_1}")
    string(FIND "${output}" "  ${name}\n" place)
    if(place EQUAL -1)
      message(FATAL_ERROR "${header}: hash.cpp does not run the method ${name}")
    endif()
  endif()
endforeach()
