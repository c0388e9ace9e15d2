# Compiles the table of bits with COMPILE, runs it with RUN before its name, and holds what it prints to golden.txt.
# Called with COMPILE, RUN, INCLUDE, EIGEN and WORK.
cmake_minimum_required(VERSION 3.25)

set(golden "${CMAKE_CURRENT_LIST_DIR}/golden.txt")
set(program "${WORK}/bits.exe")
file(MAKE_DIRECTORY "${WORK}")
list(JOIN COMPILE " " desk)

execute_process(
  COMMAND ${COMPILE} -std=c++20 -ffp-contract=off "-I${INCLUDE}" -isystem "${EIGEN}"
          "${CMAKE_CURRENT_LIST_DIR}/bits.cpp" -o "${program}"
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${desk}: the table does not compile:\n${output}")
endif()
execute_process(COMMAND ${RUN} "${program}" OUTPUT_FILE "${WORK}/table.txt" RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${desk}: the table exits with ${status}: ${error}")
endif()

file(STRINGS "${WORK}/table.txt" found)
list(TRANSFORM found STRIP)  # Windows ends a line in its own way
file(STRINGS "${golden}" expected)
if(NOT found STREQUAL expected)
  set(only_found ${found})
  set(only_expected ${expected})
  list(REMOVE_ITEM only_found ${expected})
  list(REMOVE_ITEM only_expected ${found})
  list(LENGTH only_found rows)
  list(JOIN only_found "\n  " only_found)
  list(JOIN only_expected "\n  " only_expected)
  message(FATAL_ERROR
    "${desk}: ${rows} rows have other bits than in ${golden}\nfound:\n  ${only_found}\n"
    "expected:\n  ${only_expected}\nall that was found is in ${WORK}/table.txt. It becomes the new golden.txt "
    "only where a method or a scene is new or was changed on purpose. ${program} scenes prints each scene's bits.")
endif()

# No method is left out.
file(GLOB headers "${INCLUDE}/timestep/methods/*.hpp" "${INCLUDE}/timestep/gyroscopic/*.hpp")
list(JOIN found "\n" table)
foreach(header IN LISTS headers)
  file(READ "${header}" text)
  if(text MATCHES "static constexpr const char\\* name =[ \n]*\"([^\"]*)\"")
    set(name "${CMAKE_MATCH_1}")
    string(FIND "${table}\n" "  ${name}\n" place)
    if(place EQUAL -1)
      message(FATAL_ERROR "${header}: the table has no row of ${name}")
    endif()
  endif()
endforeach()
list(LENGTH found rows)
message(NOTICE "${rows} rows have the same bits")
