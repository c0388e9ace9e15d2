# An exercise NAME of a chapter NN_chapter is
#   exercises/NN_chapter/NAME.cpp   the file that the learner completes
#   solutions/NN_chapter/NAME.cpp   the same, with an answer between two lines  // [answer]
#   tests/exercises/NN_chapter/NAME/
#     about.json       title, declaration, hints
#     properties.cpp   the hidden tests
#     correct.cpp      two answers or more that are right and written differently, each in a namespace of its own
#     mistakes.cpp     four or more that are wrong, the same; above each in comments what it says and a hint.
#                      Many may stand in several files: mistakes_KIND.cpp, read after it
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

# Sets `names` to the namespaces in files of answers, and where `words` is the name of a list, that to what is said
# above each: its `// Says: …` and `// Hint: …`, one after the other, as JSON's strings.
function(timestep_answers_in files names words)
  set(found "")
  set(all "")
  foreach(file IN LISTS files)
    file(READ "${PROJECT_SOURCE_DIR}/${file}" text)
    foreach(character "[;]=<1>" "[[]=<2>" "[]]=<3>")  # CMake's lists know these as their own
      string(REGEX MATCH "^(.+)=(<.>)$" both "${character}")
      string(REGEX REPLACE "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" text "${text}")
    endforeach()
    string(REPLACE "\n" ";" lines "${text}")
    set(kind "")
    set(Says "")
    set(Hint "")
    foreach(line IN LISTS lines)
      if(line MATCHES "^// (Says|Hint): (.+)$")
        set(kind ${CMAKE_MATCH_1})
        set(${kind} "${CMAKE_MATCH_2}")
      elseif(kind AND line MATCHES "^//       (.+)$")
        string(APPEND ${kind} " ${CMAKE_MATCH_1}")
      elseif(line MATCHES "^namespace ([A-Za-z][A-Za-z0-9_]*) {$")
        list(APPEND found ${CMAKE_MATCH_1})
        foreach(key Says Hint)
          if(words AND ${key} STREQUAL "")
            message(FATAL_ERROR "${file}: above namespace ${CMAKE_MATCH_1} a line // ${key}: must stand")
          elseif(words AND "${${key}}" IN_LIST all)
            message(FATAL_ERROR "${file}: what ${CMAKE_MATCH_1} ${key} is said of another mistake, too")
          endif()
          list(APPEND all "${${key}}")
          set(${key} "")
        endforeach()
        set(kind "")
      else()
        set(kind "")
      endif()
    endforeach()
  endforeach()
  set(${names} ${found} PARENT_SCOPE)
  if(words)
    set(json "")
    foreach(sentence IN LISTS all)
      string(REPLACE "\\" "\\\\" sentence "${sentence}")
      string(REPLACE "\"" "\\\"" sentence "${sentence}")
      list(APPEND json "\"${sentence}\"")
    endforeach()
    set(${words} "${json}" PARENT_SCOPE)
  endif()
endfunction()

# Reads an exercise, stops where something is missing, and writes into `generated` the sources that bind
# it to the checker.
function(timestep_read_exercise chapter name generated)
  set(room "tests/exercises/${chapter}/${name}")
  set(solution "solutions/${chapter}/${name}.cpp")
  foreach(file ${solution} ${room}/about.json ${room}/properties.cpp ${room}/correct.cpp ${room}/mistakes.cpp)
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

  timestep_answers_in("${room}/correct.cpp" correct "")
  list(LENGTH correct count)
  if(count LESS 2)
    message(FATAL_ERROR "${room}/correct.cpp: needs two answers, written differently, each in a namespace of its own")
  endif()
  file(GLOB kinds CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/${room}/mistakes_*.cpp")
  list(PREPEND kinds ${room}/mistakes.cpp)
  timestep_answers_in("${kinds}" mistakes words)
  list(LENGTH mistakes count)
  if(count LESS 4)
    message(FATAL_ERROR "${room}/mistakes.cpp: needs four mistakes, each in a namespace of its own")
  endif()
  # For those who tell the learner.
  set(told "{")
  set(comma "")
  foreach(mistake IN LISTS mistakes)
    list(POP_FRONT words says hint)
    string(APPEND told "${comma}\n  \"${mistake}\": {\"says\": ${says}, \"hint\": ${hint}}")
    set(comma ",")
  endforeach()
  string(APPEND told "\n}\n")
  foreach(character "<1>=;" "<2>=[" "<3>=]")
    string(SUBSTRING "${character}" 0 3 from)
    string(SUBSTRING "${character}" 4 1 to)
    string(REPLACE "${from}" "${to}" told "${told}")
  endforeach()
  file(CONFIGURE OUTPUT "${generated}/${name}_mistakes.json" CONTENT "@told@" @ONLY)
  set(included "")
  foreach(file IN LISTS kinds)
    string(APPEND included "#include \"${PROJECT_SOURCE_DIR}/${file}\"\n")
  endforeach()
  foreach(file ${room}/correct.cpp ${kinds})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${file}")
  endforeach()

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
  file(CONFIGURE OUTPUT "${generated}/${name}_here.cpp" CONTENT
"#include \"@name@.hpp\"
#include \"here.hpp\"

int main(int count, char** words) {
    return checker::check_here(\"@name@\", checker::answer_of(&@name@), count, words);
}
" @ONLY)
  set(list "")
  foreach(mistake IN LISTS mistakes)
    string(APPEND list "    {\"${mistake}\", checker::function_of(&mistakes::${mistake}::${name})},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${generated}/${name}_hidden.cpp" CONTENT
"// The mistakes that are known, with the headers that they include read before; and the hidden tests. One source, for
// reading the headers is most of the work.
#include \"@learners_header@\"
#include \"@numbers_header@\"
#include \"session.hpp\"
#include \"slips.hpp\"

namespace {
namespace mistakes {
@included@}
namespace solution {
#include \"@source@/@solution@\"
}
const bool known = checker::know(\"@name@\", {
@list@}) && checker::know_truth(\"@name@\", checker::function_of(&solution::@name@));
namespace slips {
#include \"@generated@/@name@_slips.hpp\"
}
}

#include \"@source@/@room@/properties.cpp\"
" @ONLY)
  set(list "    {\"solution\", checker::answer_of(&solution::${name})},\n")
  foreach(variant IN LISTS correct)
    string(APPEND list "    {\"correct_${variant}\", checker::answer_of(&correct::${variant}::${name})},\n")
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
namespace solution {
#include \"@source@/@solution@\"
}
namespace correct {
#include \"@source@/@room@/correct.cpp\"
}
const bool known = checker::know_variants(\"@name@\", {checker::answer_of(&stub::@name@), {
@list@}});
}
" @ONLY)
endfunction()
