# An exercise NAME of a chapter NN_chapter is
#   exercises/NN_chapter/NAME.cpp   the file that the learner completes
#   solutions/NN_chapter/NAME.cpp   the same, with an answer between two lines  // [answer]
#   tests/exercises/NN_chapter/NAME/
#     about.json       title, declaration, hints, known mistakes: what people are told
#     properties.cpp   the hidden tests
#     correct_*.cpp    two answers or more that are right and written differently
#     mistake_*.cpp    four or more that are wrong, each in a way that about.json names
# One that lacks any of them is a configure error; but for the learner's own, since nothing that a
# learner does to exercises/ may break the build: a test looks for those (tests/exercises/files.cmake).

# Sets `result` to the words about.json has for the keys given.
function(timestep_words json where result)
  string(JSON type ERROR_VARIABLE error TYPE "${json}" ${ARGN})
  list(JOIN ARGN "." key)
  if(error OR NOT type STREQUAL "STRING")
    message(FATAL_ERROR "${where}: ${key} must be words")
  endif()
  string(JSON words GET "${json}" ${ARGN})
  if(words STREQUAL "")
    message(FATAL_ERROR "${where}: ${key} is empty")
  endif()
  set(${result} "${words}" PARENT_SCOPE)
endfunction()

# Reads an exercise, stops where something is missing, and writes into `generated` the sources that bind
# it to the checker.
function(timestep_read_exercise chapter name generated)
  set(room "tests/exercises/${chapter}/${name}")
  set(solution "solutions/${chapter}/${name}.cpp")
  foreach(file ${solution} ${room}/about.json ${room}/properties.cpp)
    if(NOT EXISTS "${PROJECT_SOURCE_DIR}/${file}")
      message(FATAL_ERROR "exercise ${name}: ${file} is missing")
    endif()
  endforeach()
  file(STRINGS "${PROJECT_SOURCE_DIR}/${room}/properties.cpp" properties REGEX "^PROPERTY\\(")
  if(NOT properties)
    message(FATAL_ERROR "exercise ${name}: ${room}/properties.cpp holds no PROPERTY")
  endif()

  set(about "${room}/about.json")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${about}")
  file(READ "${PROJECT_SOURCE_DIR}/${about}" json)
  string(JSON type ERROR_VARIABLE error TYPE "${json}")
  if(error)
    message(FATAL_ERROR "${about}: is not JSON (${error})")
  endif()
  foreach(key title level practises declaration learned)
    timestep_words("${json}" "${about}" ${key} ${key})
  endforeach()
  if(NOT declaration MATCHES "[ &]${name}\\(.*\\)$")
    message(FATAL_ERROR "${about}: declaration must declare ${name}")
  endif()
  string(JSON type ERROR_VARIABLE error TYPE "${json}" number)
  if(NOT type STREQUAL "NUMBER")
    message(FATAL_ERROR "${about}: number must be the exercise's place in its chapter")
  endif()
  string(JSON hints ERROR_VARIABLE error LENGTH "${json}" hints)
  if(error OR hints LESS 2)
    message(FATAL_ERROR "${about}: hints must be two or more, from a nudge to nearly the answer")
  endif()
  string(JSON eigen ERROR_VARIABLE error GET "${json}" eigen)
  if(NOT eigen MATCHES "^(ON|OFF)$")
    message(FATAL_ERROR "${about}: eigen must be true or false")
  endif()

  file(GLOB correct CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/${room}" "${PROJECT_SOURCE_DIR}/${room}/correct_*.cpp")
  list(LENGTH correct count)
  if(count LESS 2)
    message(FATAL_ERROR "exercise ${name}: ${room} needs two files correct_*.cpp, written differently")
  endif()
  file(GLOB mistakes CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/${room}" "${PROJECT_SOURCE_DIR}/${room}/mistake_*.cpp")
  list(LENGTH mistakes count)
  if(count LESS 4)
    message(FATAL_ERROR "exercise ${name}: ${room} needs four files mistake_*.cpp")
  endif()
  list(TRANSFORM mistakes REPLACE "^mistake_(.*)\\.cpp$" "\\1")
  set(told "")
  foreach(mistake IN LISTS mistakes)
    foreach(key says hint)
      timestep_words("${json}" "${about}" words mistakes ${mistake} ${key})
      if("${words}" IN_LIST told)
        message(FATAL_ERROR "${about}: mistakes.${mistake}.${key} is said of another mistake, too")
      endif()
      list(APPEND told "${words}")
    endforeach()
  endforeach()
  string(JSON count LENGTH "${json}" mistakes)
  list(LENGTH mistakes files)
  if(NOT count EQUAL files)
    message(FATAL_ERROR "${about}: mistakes names ${count}, but there are ${files} files mistake_*.cpp")
  endif()

  # The file as the learner gets it.
  file(READ "${PROJECT_SOURCE_DIR}/${solution}" solved)
  string(REGEX REPLACE "\n( *)// \\[answer\\]\n.*\n *// \\[answer\\]\n" "\n\\1return not_started;  // your answer\n" stub "${solved}")
  if(stub STREQUAL solved)
    message(FATAL_ERROR "${solution}: needs two lines // [answer], round what the learner is to write")
  endif()
  string(FIND "${stub}" "${declaration} {" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${solution}: must define \"${declaration}\", as about.json declares it")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${solution}")
  file(CONFIGURE OUTPUT "${generated}/${name}_stub.cpp" CONTENT "@stub@" @ONLY)

  # The sources that bind it.
  set(learners_header exercise.hpp)
  set(numbers_header numbers.hpp)
  if(eigen)
    set(learners_header exercise_eigen.hpp)
    set(numbers_header numbers_eigen.hpp)
  endif()
  set(source "${PROJECT_SOURCE_DIR}")
  # Read before the learner's file, so that another return type does not compile.
  file(CONFIGURE OUTPUT "${generated}/${name}_declared.hpp" CONTENT
"#line 1 \"what the exercise declares\"
@declaration@;
" @ONLY)
  file(CONFIGURE OUTPUT "${generated}/${name}.hpp" CONTENT
"#pragma once
#include \"@learners_header@\"
#include \"@numbers_header@\"
#include \"@name@_declared.hpp\"
" @ONLY)
  file(CONFIGURE OUTPUT "${generated}/${name}_worker.cpp" CONTENT
"#include \"@name@.hpp\"
#include \"worker.hpp\"

int main() {
    return checker::serve(checker::answer_of(&@name@));
}
" @ONLY)
  set(includes "")
  set(list "")
  foreach(mistake IN LISTS mistakes)
    string(APPEND includes "namespace mistake_${mistake} {\n#include \"${source}/${room}/mistake_${mistake}.cpp\"\n}\n")
    string(APPEND list "    {\"${mistake}\", checker::answer_of(&mistake_${mistake}::${name})},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${generated}/${name}_hidden.cpp" CONTENT
"// The mistakes that are known, each in a namespace of its own, with the headers that they include read
// before; and the hidden tests. One source, for reading the headers is most of the work.
#include \"@learners_header@\"
#include \"@numbers_header@\"
#include \"session.hpp\"

namespace {
@includes@
const bool known = checker::know(\"@name@\", {
@list@});
}

#include \"@source@/@room@/properties.cpp\"
" @ONLY)
  set(includes "")
  set(list "")
  set(place 0)
  foreach(file "${source}/${solution}" ${correct})
    cmake_path(GET file STEM LAST_ONLY stem)
    if(place EQUAL 0)
      set(stem solution)
    else()
      set(file "${source}/${room}/${file}")
    endif()
    math(EXPR place "${place} + 1")
    string(APPEND includes "namespace ${stem} {\n#include \"${file}\"\n}\n")
    string(APPEND list "    {\"${stem}\", checker::answer_of(&${stem}::${name})},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${generated}/${name}_variants.cpp" CONTENT
"// Each in a namespace of its own; the headers they include are read before.
#include \"@learners_header@\"
#include \"@numbers_header@\"
#include \"self_test.hpp\"

namespace {
namespace stub {
#include \"@generated@/@name@_stub.cpp\"
}
@includes@
const bool known = checker::know_variants(\"@name@\", {checker::answer_of(&stub::@name@), {
@list@}});
}
" @ONLY)
endfunction()
