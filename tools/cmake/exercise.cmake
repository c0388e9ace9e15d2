# An exercise NAME of a chapter NN_chapter is
#   exercises/NN_chapter/NAME.cpp   the file that the learner completes
#   solutions/NN_chapter/NAME.cpp   the same, with an answer between two lines  // [answer]
#   tests/exercises/NN_chapter/NAME/
#     about.json       title, declaration, hints
#     properties.cpp   the hidden tests
#     correct.cpp      two answers or more that are right and written differently, each in a namespace of its own
#     mistakes.diff    four or more that are wrong: what each says, a hint, and the edit of a right answer that makes it
# One that lacks any of them is a configure error; but for the learner's own, since nothing that a
# learner does to exercises/ may break the build: a test looks for those (tests/exercises/files.cmake).
# What correct.cpp and mistakes.diff hold, write_mistakes reads when the tests are built.

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
  foreach(file ${solution} ${room}/about.json ${room}/properties.cpp ${room}/correct.cpp ${room}/mistakes.diff)
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
  file(CONFIGURE OUTPUT "${generated}/${name}_check_in_process.cpp" CONTENT
"#include \"@name@.hpp\"
#include \"check_in_process.hpp\"

int main(int count, char** words) {
    return checker::check_in_process(\"@name@\", checker::answer_of(&@name@), count, words);
}
" @ONLY)
  file(CONFIGURE OUTPUT "${generated}/${name}_hidden.cpp" CONTENT
"// The mistakes that are known, with the headers that they include read before; and the hidden tests. One source, for
// reading the headers is most of the work.
#include \"@learners_header@\"
#include \"@numbers_header@\"
#include \"session.hpp\"
#include \"slips.hpp\"

namespace {
namespace mistakes {
#include \"@name@_mistakes.hpp\"
}
namespace solution {
#include \"@source@/@solution@\"
}
const bool known = checker::register_mistakes(\"@name@\", mistakes::all) && checker::register_truth(\"@name@\", checker::function_of(&solution::@name@));
namespace slips {
#include \"@name@_slips.hpp\"
}
}

#include \"@source@/@room@/properties.cpp\"
" @ONLY)
  file(CONFIGURE OUTPUT "${generated}/${name}_variants.cpp" CONTENT
"// Each in a namespace of its own; the headers they include are read before.
#include \"@learners_header@\"
#include \"@numbers_header@\"
#include \"registry.hpp\"

namespace {
namespace stub {
#include \"@generated@/@name@_stub.cpp\"
}
namespace solution {
#include \"@source@/@solution@\"
}
namespace correct {
#include \"@source@/@room@/correct.cpp\"
#include \"@name@_correct.hpp\"
}
const bool known = checker::register_variants(\"@name@\", checker::answer_of(&stub::@name@), checker::answer_of(&solution::@name@), correct::all);
}
" @ONLY)
endfunction()

# What the build writes of an exercise before its tests are compiled: its mistakes as C++ and what is said of them, the
# list of its right answers, and its slips.
function(timestep_write_answers chapter name generated)
  set(solution "${PROJECT_SOURCE_DIR}/solutions/${chapter}/${name}.cpp")
  set(room "${PROJECT_SOURCE_DIR}/tests/exercises/${chapter}/${name}")
  add_custom_command(OUTPUT "${generated}/${name}_mistakes.hpp" "${generated}/${name}_mistakes.json" "${generated}/${name}_correct.hpp"
    COMMAND write_mistakes ${name} "${generated}" "${solution}" "${room}/correct.cpp" "${room}/mistakes.diff"
    DEPENDS write_mistakes "${solution}" "${room}/correct.cpp" "${room}/mistakes.diff"
    COMMENT "Writing the mistakes of ${name}" VERBATIM)
  add_custom_command(OUTPUT "${generated}/${name}_slips.hpp"
    COMMAND write_slips ${name} "${generated}/${name}_slips.hpp" "${solution}" "${room}/correct.cpp"
    DEPENDS write_slips "${solution}" "${room}/correct.cpp" COMMENT "Writing the slips of ${name}" VERBATIM)
endfunction()

# The programs that write them.
function(timestep_answer_writers)
  add_executable(write_mistakes EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/tools/checker/write_mistakes.cpp")
  add_executable(write_slips EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/tools/checker/slips/write_slips.cpp")
  foreach(writer write_mistakes write_slips)
    target_link_libraries(${writer} PRIVATE timestep_warnings)
    target_compile_features(${writer} PRIVATE cxx_std_20)
  endforeach()
endfunction()
