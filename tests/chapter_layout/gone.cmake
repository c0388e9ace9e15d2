# What CMake has found and what is then taken from the machine makes it look again, by itself, when
# something is built. Expects ROOT, WORK, COMPILER, GENERATOR, MAKE, EIGEN.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
find_program(REAL gnuplot)
file(CREATE_LINK "${REAL}" "${WORK}/gnuplot" SYMBOLIC)

function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} exits with ${status}:\n${words}")
  endif()
  set(words "${words}" PARENT_SCOPE)
endfunction()
run("configuring" "${CMAKE_COMMAND}" -S "${ROOT}" -B "${WORK}/build" -G "${GENERATOR}" "-DCMAKE_MAKE_PROGRAM=${MAKE}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DEigen3_DIR=${EIGEN}" "-DGNUPLOT=${WORK}/gnuplot"
  -DTIMESTEP_TESTS=OFF -DTIMESTEP_COURSE=OFF)
# A target that builds nothing, and looks at what CMake has read.
set(nothing build.ninja)
if(GENERATOR MATCHES "Makefiles")
  set(nothing cmake_check_build_system)
endif()
run("a build" "${CMAKE_COMMAND}" --build "${WORK}/build" --target ${nothing})
if(words MATCHES "gone")
  message(FATAL_ERROR "Nothing was gone yet:\n${words}")
endif()
file(REMOVE "${WORK}/gnuplot")
run("a build without what was found" "${CMAKE_COMMAND}" --build "${WORK}/build" --target ${nothing})
file(STRINGS "${WORK}/build/CMakeCache.txt" found REGEX "^GNUPLOT:")
if(NOT words MATCHES "gnuplot is gone; looking for another" OR NOT found STREQUAL "GNUPLOT:FILEPATH=${REAL}")
  message(FATAL_ERROR "What was gone was not looked for again: ${found}\n${words}")
endif()

# What has to be there is named with its package.
foreach(needed "CLI11;libcli11-dev" "nlohmann_json;nlohmann-json3-dev")
  list(GET needed 0 package)
  list(GET needed 1 debian)
  execute_process(COMMAND "${CMAKE_COMMAND}" -B "${WORK}/build" -S "${ROOT}" -UCMAKE_DISABLE_FIND_PACKAGE_*
    -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON     RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE words)
  if(status EQUAL 0 OR NOT words MATCHES "\n  ${package} is not installed \\(Debian's package ${debian}\\)\n")
    message(FATAL_ERROR "without ${package} the configuration exits with ${status}:\n${words}")
  endif()
endforeach()
