# Plain CMake is enough: configure, build, ctest and the target docs, on a machine that has none of
# what only the course program and the looks of the site need. Warnings are errors.
include("${CMAKE_CURRENT_LIST_DIR}/nested.cmake")

# The reader's CMake takes make where Ninja is not asked for, and so does this build. A machine that
# was set up by `./course` may have Ninja only.
find_program(MAKE_PROGRAM NAMES make gmake)
if(MAKE_PROGRAM)
  set(generator -G "Unix Makefiles" "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}")
else()
  set(generator -G Ninja)
endif()
configure(strict ${generator} -DCMAKE_CXX_FLAGS_RELEASE=-O1\ -DNDEBUG
  -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON
  -DKATEX= -DAWESOME=)
foreach(sentence
    "CLI11 or nlohmann-json not found: the course program is left out"
    "KaTeX not found: formulas stand as TeX source (package libjs-katex)"
    "doxygen-awesome-css not found: Doxygen's own theme (package doxygen-awesome-css)")
  string(FIND "${said}" "${sentence}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "the configuration must say \"${sentence}\", but says\n${said}")
  endif()
endforeach()

step("build" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2)
if(EXISTS "${WORK}/tools/course/course")
  message(FATAL_ERROR "the course program was built without what it needs")
endif()
step("docs" "${CMAKE_COMMAND}" --build "${WORK}" --parallel 2 --target docs)
if(NOT EXISTS "${WORK}/site/html/index.html")
  message(FATAL_ERROR "the target docs left no site/html/index.html")
endif()
# What does not depend on the compiler or on the site's looks has been tested in the build around
# this one.
step("ctest" "${CMAKE_CTEST_COMMAND}" --test-dir "${WORK}" --parallel 2 --output-on-failure
  --no-tests=error --label-exclude "heavy|browser" --exclude-regex "^(front door|instructions:|site: (every written page|planted)) ")
message(STATUS "${said}")
