# A newcomer adds a chapter and an exercise by the commands in README.md, word for word, and a chapter with all optional
# parts. Each is whole: it is configured, built and run, its tests pass, its page is filled, and the tests of the exercise
# tell right from wrong. Expects ROOT, WORK, COMPILER, GENERATOR, MAKE, EIGEN, COURSE (the course program on a fixture),
# PAGE (the page tool), and CATCH2 or CATCH2_SOURCE.
cmake_minimum_required(VERSION 3.25)

set(fixture "${WORK}/course")
set(build "${WORK}/build")
function(step what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${fixture}" RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what}: exits with ${status}\n${output}")
  endif()
endfunction()

# The course with its smallest chapter alone, to be quick.
file(REMOVE_RECURSE "${WORK}")
foreach(part CMakeLists.txt include tools engines docs README.md LICENSE chapters/CMakeLists.txt chapters/01_derivatives
    tests/CMakeLists.txt tests/support tests/chapters/01_derivatives.cpp)
  cmake_path(GET part PARENT_PATH folder)
  file(COPY "${ROOT}/${part}" DESTINATION "${fixture}/${folder}")
endforeach()
file(COPY "${ROOT}/tests/exercises" DESTINATION "${fixture}/tests" FILES_MATCHING PATTERN "*.txt" PATTERN "*.cmake")
file(WRITE "${fixture}/course" "#!/bin/sh\nexport 'FIXTURE_SOURCE=${fixture}' 'FIXTURE_BUILD=${build}' \
'FIXTURE_CMAKE=${CMAKE_COMMAND}' FIXTURE_CTEST=false\nexec '${COURSE}' \"$@\"\n")
file(CHMOD "${fixture}/course" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
set(catch2 "-DFETCHCONTENT_SOURCE_DIR_CATCH2=${CATCH2_SOURCE}")
if(CATCH2)
  set(catch2 "-DCatch2_DIR=${CATCH2}")
endif()
step("configure" "${CMAKE_COMMAND}" -G "${GENERATOR}" -S . -B "${build}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_MAKE_PROGRAM=${MAKE}" "-DEigen3_DIR=${EIGEN}" -DTIMESTEP_COURSE=OFF ${catch2}
  -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DTIMESTEP_STRICT=ON)

file(READ "${ROOT}/README.md" readme)
if(NOT readme MATCHES "## Adding a chapter[^#]*```sh\n([^`]*)```")
  message(FATAL_ERROR "README.md: no commands under \"Adding a chapter\"")
endif()
step("the commands in README.md" sh -e -c "${CMAKE_MATCH_1}")
step("a chapter with all" ./course new chapter all_of_it --all)
step("the table of README.md" "${CMAKE_COMMAND}" "-DROOT=${fixture}" -DCHECK=ON -P tools/cmake/readme_table.cmake)

step("build and run" "${CMAKE_COMMAND}" --build "${build}" --parallel 2
  --target run_my_topic run_all_of_it live_of_03_all_of_it timestep_tests self_test)
step("the chapter's tests" "${build}/tests/timestep_tests" "all_of_it: *")
foreach(chapter 02_my_topic 03_all_of_it)
  step("page of ${chapter}" "${PAGE}" --source "${fixture}" --runs "${build}/chapters" --chapter ${chapter}
    --figures "${WORK}/figures" --input chapters/${chapter}/chapter.md --output "${WORK}/${chapter}.md"
    --index "${WORK}/${chapter}.tsv")
  if(NOT EXISTS "${build}/chapters/${chapter}/run/fall.svg")
    message(FATAL_ERROR "${chapter}: no picture")
  endif()
endforeach()
step("the tests of the exercise's tests" "${build}/exercises/self_test" my_function 200)
