# A newcomer adds a chapter and an exercise by the commands in README.md, word for word. What they write is whole: it
# is configured, built and run, it draws its figure, its tests pass, its page is filled, and the tests of the exercise
# tell right from wrong. Called as incomplete.cmake is, and with COURSE (the course program on a fixture), GNUPLOT, PAGE
# (the page tool), CATCH2 or CATCH2_SOURCE.
include("${CMAKE_CURRENT_LIST_DIR}/fixture.cmake")

function(step what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${fixture}" RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what}: exits with ${status}\n${output}")
  endif()
endfunction()

# The course with its smallest chapter alone, to be quick.
set_fixture()
file(COPY "${ROOT}/docs" "${ROOT}/README.md" "${ROOT}/LICENSE" DESTINATION "${fixture}")
file(COPY "${ROOT}/chapters/01_derivatives" DESTINATION "${fixture}/chapters")
file(COPY "${ROOT}/tests/CMakeLists.txt" "${ROOT}/tests/support" DESTINATION "${fixture}/tests")
file(COPY "${ROOT}/tests/chapters/01_derivatives.cpp" DESTINATION "${fixture}/tests/chapters")
file(COPY "${ROOT}/tests/exercises" DESTINATION "${fixture}/tests" FILES_MATCHING PATTERN "*.txt" PATTERN "*.cmake")
file(WRITE "${fixture}/course" "#!/bin/sh\nexport 'FIXTURE_SOURCE=${fixture}' 'FIXTURE_BUILD=${WORK}/build' \
'FIXTURE_CMAKE=${CMAKE_COMMAND}' FIXTURE_CTEST=false\nexec '${COURSE}' \"$@\"\n")
file(CHMOD "${fixture}/course" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)

if(CATCH2)
  set(catch2 "-DCatch2_DIR=${CATCH2}")
else()
  set(catch2 "-DFETCHCONTENT_SOURCE_DIR_CATCH2=${CATCH2_SOURCE}")
endif()
configure(${catch2} -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DTIMESTEP_STRICT=ON)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "configure: ${output}")
endif()

file(READ "${ROOT}/README.md" readme)
if(NOT readme MATCHES "## Adding a chapter[^#]*```sh\n([^`]*)```")
  message(FATAL_ERROR "README.md: no commands under \"Adding a chapter\"")
endif()
step("the commands in README.md" sh -e -c "${CMAKE_MATCH_1}")

set(chapter 02_my_topic)  # here it is the second
step("build and run" "${CMAKE_COMMAND}" --build "${WORK}/build" --parallel 2
  --target run_my_topic live_of_${chapter} timestep_tests self_test)
step("the chapter's tests" "${WORK}/build/tests/timestep_tests" "my_topic: *")
step("the program by its one line" "${CMAKE_COMMAND}" "-DROOT=${fixture}" -DCHAPTER=${chapter} -DNAME=my_topic
  "-DCOMPILER=${COMPILER}" "-DWORK=${WORK}/one_line" -P "${ROOT}/tests/programs/one_line.cmake")
step("the panel" sh "${ROOT}/tests/live/extremes.sh" "${WORK}/build/chapters/live_my_topic")
file(READ "${fixture}/chapters/${chapter}/live/my_topic.cpp" panel)
string(REPLACE "// still: steps=20" "// still: steps=7" panel "${panel}")
file(WRITE "${fixture}/chapters/${chapter}/live/my_topic.cpp" "${panel}")
step("another still" "${CMAKE_COMMAND}" --build "${WORK}/build" --target live_of_${chapter})
file(STRINGS "${WORK}/build/chapters/${chapter}/live/my_topic.txt" steps REGEX " steps$")
if(NOT steps STREQUAL "7 steps")
  message(FATAL_ERROR "the panel's still is drawn after ${steps}, its line says 7")
endif()
step("page" "${PAGE}" --source "${fixture}" --runs "${WORK}/build/chapters" --chapter ${chapter}
  --figures "${WORK}/figures" --input chapters/${chapter}/chapter.md --output "${WORK}/page.md"
  --index "${WORK}/index.tsv")
foreach(result page.md index.tsv build/chapters/${chapter}/run/done build/chapters/${chapter}/run/fall.svg)
  if(NOT EXISTS "${WORK}/${result}")
    message(FATAL_ERROR "${result} was not made")
  endif()
endforeach()
file(READ "${WORK}/page.md" page)
if(NOT page MATCHES "My function")
  message(FATAL_ERROR "the chapter's page does not show its exercise")
endif()

step("the tests of the exercise's tests" "${WORK}/build/exercises/self_test" my_function 200)
foreach(script files handed_out)
  step("${script}" "${CMAKE_COMMAND}" "-DROOT=${fixture}" "-DGENERATED=${WORK}/build/exercises/generated"
    -P "${ROOT}/tests/exercises/${script}.cmake")
endforeach()
