# Takes one thing after another out of an exercise: the configuration must fail, and say what is missing
# where. Expects ROOT, WORK, GENERATOR and MAKE.
cmake_minimum_required(VERSION 3.25)

set(fixture "${WORK}/course")
set(room tests/exercises/01_derivatives/velocity_now)
set(solution solutions/01_derivatives/velocity_now.cpp)

# The exercise, whole, in a project that reads nothing else.
function(furnish)
  file(REMOVE_RECURSE "${fixture}")
  file(COPY "${ROOT}/${room}" DESTINATION "${fixture}/tests/exercises/01_derivatives")
  file(COPY "${ROOT}/${solution}" DESTINATION "${fixture}/solutions/01_derivatives")
  file(WRITE "${fixture}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(fixture LANGUAGES NONE)
include(\"${ROOT}/tools/cmake/exercise.cmake\")
timestep_read_exercise(01_derivatives velocity_now \"\${PROJECT_BINARY_DIR}/generated\")\n")
endfunction()

macro(configure)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${fixture}" -B "${WORK}/build"
            "-DCMAKE_MAKE_PROGRAM=${MAKE}"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
endmacro()

macro(must_fail what words)
  configure()
  string(FIND "${output}" "${words}" place)
  if(status EQUAL 0)
    message(SEND_ERROR "${what}: the configuration succeeds")
  elseif(place EQUAL -1)
    message(SEND_ERROR "${what}: must say \"${words}\", but says: ${output}")
  endif()
  furnish()
endmacro()

furnish()
configure()
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the whole exercise must be configured, but: ${output}")
endif()
# What the learner gets is the solution without its answer.
file(READ "${WORK}/build/generated/velocity_now_stub.cpp" made)
if(NOT made MATCHES "h\\) {\n    return not_started;  // your answer\n}\n$")
  message(SEND_ERROR "the stub is\n${made}")
endif()

foreach(file ${solution} ${room}/about.json ${room}/properties.cpp ${room}/correct.cpp ${room}/mistakes.diff)
  file(REMOVE "${fixture}/${file}")
  must_fail("without ${file}" "exercise velocity_now: ${file} is missing")
endforeach()
file(WRITE "${fixture}/${room}/properties.cpp" "int nothing;\n")
must_fail("no property" "${room}/properties.cpp holds no PROPERTY")

file(READ "${ROOT}/${room}/about.json" about)
foreach(key number title level practises declaration eigen hints learned)
  string(JSON without REMOVE "${about}" ${key})
  file(WRITE "${fixture}/${room}/about.json" "${without}")
  must_fail("about.json without ${key}" "${room}/about.json: ${key}")
endforeach()
foreach(mistake
    "one hint|hints|[\"only one\"]|hints must be two or more"
    "another declaration|declaration|\"double velocity(double h)\"|declaration must declare velocity_now"
    "no title|title|\"\"|title is empty")
  string(REPLACE "|" ";" mistake "${mistake}")
  list(GET mistake 0 what)
  list(GET mistake 1 key)
  list(GET mistake 2 value)
  list(GET mistake 3 words)
  string(JSON wrong SET "${about}" ${key} "${value}")
  file(WRITE "${fixture}/${room}/about.json" "${wrong}")
  must_fail("${what}" "${words}")
endforeach()
file(WRITE "${fixture}/${room}/about.json" "{ \"title\": ")
must_fail("a torn about.json" "${room}/about.json: is not JSON")

file(READ "${ROOT}/${solution}" text)
string(REPLACE "// [answer]" "" unmarked "${text}")
file(WRITE "${fixture}/${solution}" "${unmarked}")
must_fail("an unmarked answer" "needs two lines // [answer]")
string(REPLACE "double h)" "double step)" renamed "${text}")
file(WRITE "${fixture}/${solution}" "${renamed}")
must_fail("another signature" "as about.json declares it")
