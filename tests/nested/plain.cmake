# Plain CMake is enough: configure, build, ctest and the target docs, without the course program and on a machine that
# has none of what only the counts of instructions, the other libraries in chapter 7 and the looks of the site need.
# Warnings are errors. The sanitizers for addresses and undefined behaviour find nothing in the tests of library and
# chapters, nor in any chapter's program and study as they draw the figures and as they are given bad input: these are
# compiled with the flags of the preset `sanitize`. (The flags leave out checks of every pointer, null, alignment,
# object-size and vptr, which double the time to compile Eigen: the address sanitizer stops at a null pointer, Eigen at
# a misaligned vector, and nothing here is virtual.)
#
# Called with ROOT, WORK, COMPILER, EIGEN, and CATCH2 or CATCH2_SOURCE.
cmake_minimum_required(VERSION 3.25)

# Engines are tested by the build around this one.
unset(ENV{TIMESTEP_BOX3D})
unset(ENV{TIMESTEP_JOLT})

# Runs a step that must succeed; the end of its output goes to `said`.
function(step what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    string(LENGTH "${said}" length)
    math(EXPR from "${length} - 6000")
    if(from GREATER 0)
      string(SUBSTRING "${said}" ${from} -1 said)
    endif()
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${what}: ${command}\nexits with ${status}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

# With the preset's flags mistakes must be found, else all that follows proves nothing.
file(READ "${ROOT}/CMakePresets.json" presets)
if(NOT presets MATCHES "\"CMAKE_CXX_FLAGS_SANITIZE\": \"([^\"]+)\"")
  message(FATAL_ERROR "CMakePresets.json: the preset sanitize has no CMAKE_CXX_FLAGS_SANITIZE")
endif()
set(sanitize "${CMAKE_MATCH_1}")
separate_arguments(flags UNIX_COMMAND "${sanitize}")
file(MAKE_DIRECTORY "${WORK}")
step("canary" "${COMPILER}" ${flags} "${CMAKE_CURRENT_LIST_DIR}/canary.cpp" -o "${WORK}/canary")
step("a canary that is well" "${WORK}/canary" 0)
foreach(mistake 1 2)
  execute_process(COMMAND "${WORK}/canary" ${mistake} RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    message(FATAL_ERROR "canary.cpp: mistake ${mistake} was not found with ${sanitize}")
  endif()
endforeach()

# A reader's CMake takes make where Ninja is not asked for. A machine that `./course` set up may have Ninja only.
set(options -G Ninja)
find_program(MAKE_PROGRAM NAMES make gmake)
if(MAKE_PROGRAM)
  set(options -G "Unix Makefiles" "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}")
endif()
if(CATCH2)
  list(APPEND options "-DCatch2_DIR=${CATCH2}")
else()
  list(APPEND options "-DFETCHCONTENT_SOURCE_DIR_CATCH2=${CATCH2_SOURCE}")
endif()
step("configure" "${CMAKE_COMMAND}" --preset strict -S "${ROOT}" -B "${WORK}" ${options}
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DEigen3_DIR=${EIGEN}" -DTIMESTEP_NESTED_TESTS=OFF
  "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
  "-DCMAKE_PROJECT_timestep_INCLUDE=${CMAKE_CURRENT_LIST_DIR}/sanitize.cmake" "-DSANITIZE=${sanitize}"
  -DTIMESTEP_COURSE=OFF -DTIMESTEP_WITHOUT=ODEINT,GSL,SUNDIALS,BULLET,ODE -DVALGRIND= -DKATEX= -DAWESOME= -DLUNR=)
string(FIND "${said}" "GSL not found: it is left out of the diagrams (package libgsl-dev)" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the configuration must say what is left out without GSL, but says\n${said}")
endif()
step("build and docs" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2 --target all docs)
if(NOT EXISTS "${WORK}/site/html/index.html")
  message(FATAL_ERROR "the target docs left no site/html/index.html")
endif()
# What depends neither on the compiler nor on the site's looks is tested by the build around this one.
step("ctest" "${CMAKE_CTEST_COMMAND}" --test-dir "${WORK}" --parallel 2 --output-on-failure
  --no-tests=error --label-exclude "long|release" --exclude-regex
  "^(front door|readme:|a chapter|an exercise that|site: (a page|every p|planted|films|the book|grows)) |(its tests are tested.*|slips of its right answers are caught)$")
message(STATUS "${said}")
