# A newcomer adds a chapter by the steps in README.md, word for word where they are commands: it is
# configured, built and run, it draws its figures, its tests pass and its page is filled.
# Called as incomplete.cmake is, and with GNUPLOT, PAGE (the page tool), CATCH2 or CATCH2_SOURCE.
include("${CMAKE_CURRENT_LIST_DIR}/stage.cmake")

function(step what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${stage}" RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what}: exits with ${status}\n${output}")
  endif()
endfunction()

# Replaces in a file of the stage; what is to be replaced must be there.
function(edit file pattern replacement)
  file(READ "${stage}/${file}" text)
  string(REGEX REPLACE "${pattern}" "${replacement}" changed "${text}")
  if(changed STREQUAL text)
    message(FATAL_ERROR "${file}: holds nothing like ${pattern}")
  endif()
  file(WRITE "${stage}/${file}" "${changed}")
endfunction()

# The course with its smallest chapter alone, to be quick.
set_stage()
file(COPY "${ROOT}/docs" DESTINATION "${stage}")
file(COPY "${ROOT}/chapters/01_derivatives" DESTINATION "${stage}/chapters")
file(COPY "${ROOT}/tests/CMakeLists.txt" "${ROOT}/tests/support" DESTINATION "${stage}/tests")
file(COPY "${ROOT}/tests/chapters/01_derivatives.cpp" DESTINATION "${stage}/tests/chapters")

# Step 1, the commands in README.md.
file(READ "${ROOT}/README.md" readme)
if(NOT readme MATCHES "## Adding a chapter[^#]*```sh\n([^`]*)```")
  message(FATAL_ERROR "README.md: no commands under \"Adding a chapter\"")
endif()
step("the commands in README.md" sh -e -c "${CMAKE_MATCH_1}")

# Steps 2 and 3: what a newcomer writes anew, here in the fewest words.
set(room chapters/09_my_topic)
edit(${room}/about.json "\"rows\": [^]]*]" "\"rows\": []")
edit(${room}/about.json "\"title\": \"[^\"]*\"" "\"title\": \"My topic\"")
edit(${room}/study/study.cpp "program\\(\"derivatives\"" "program(\"my_topic\"")
edit(${room}/chapter.md "^# [^{]*{#chapter_01}" "# My topic {#chapter_09}")
edit(${room}/chapter.md "ch1_" "ch9_")
edit(${room}/chapter.md "{{rows [^}]*}}" "")
edit(${room}/chapter.md "(\\.svg|\\.gif)( N[0-9][0-9]| I[0-9][0-9])+:" "\\1:")
edit(tests/chapters/09_my_topic.cpp "TEST_CASE\\(\"" "TEST_CASE(\"my topic: ")
edit(tests/chapters/09_my_topic.cpp "\\[[NI][0-9][0-9]\\]" "")

if(CATCH2)
  set(catch2 "-DCatch2_DIR=${CATCH2}")
else()
  set(catch2 "-DFETCHCONTENT_SOURCE_DIR_CATCH2=${CATCH2_SOURCE}")
endif()
configure(${catch2} -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DTIMESTEP_STRICT=ON)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "configure: ${output}")
endif()
step("build and run" "${CMAKE_COMMAND}" --build "${WORK}/build" --parallel 2
  --target run_my_topic timestep_tests)
step("tests" "${WORK}/build/tests/timestep_tests" "my topic: *")
step("page" "${PAGE}" --source "${stage}" --runs "${WORK}/build/chapters" --chapter 09_my_topic
  --figures "${WORK}/figures" --input ${room}/chapter.md --output "${WORK}/page.md"
  --index "${WORK}/index.tsv")
foreach(result page.md index.tsv build/${room}/run/done)
  if(NOT EXISTS "${WORK}/${result}")
    message(FATAL_ERROR "${result} was not made")
  endif()
endforeach()
