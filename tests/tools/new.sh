# Tests of `course new`: a chapter or an exercise is made whole, or nothing is.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

# A checkout that CMake can configure: chapters are targets, exercises are read as in earnest.
fixture_for_new() {
    mkdir -p source/tests/chapters source/tests/exercises/03_swing source/solutions/03_swing source/exercises/03_swing
    cp -r "$source/tools/new" source/tools
    printf '| [1 A](chapters/01_fall) | Why? |\n| [3 B](chapters/03_swing) | Why? |\n\nAnd so on.\n' >source/README.md
    cp -r "$source/tests/exercises/01_derivatives/velocity_now" source/tests/exercises/03_swing
    cp "$source/solutions/01_derivatives/velocity_now.cpp" source/solutions/03_swing
    cp "$source/exercises/01_derivatives/velocity_now.cpp" source/exercises/03_swing
    cat >source/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(fixture LANGUAGES NONE)
include(tools/cmake/exercise.cmake)
file(GLOB chapters RELATIVE "${PROJECT_SOURCE_DIR}/chapters" chapters/*)
foreach(chapter IN LISTS chapters ITEMS 00_docs)
  string(REGEX REPLACE "^[0-9]+_" "" name "${chapter}")
  add_custom_target(${name})
endforeach()
file(GLOB rooms RELATIVE "${PROJECT_SOURCE_DIR}/tests/exercises" tests/exercises/*/*/about.json)
foreach(room IN LISTS rooms)
  string(REPLACE "/" ";" room "${room}")
  list(GET room 0 chapter)
  list(GET room 1 name)
  timestep_read_exercise(${chapter} ${name} "${PROJECT_BINARY_DIR}/exercises/generated")
endforeach()
END
    ! command -v ninja >/dev/null || export CMAKE_GENERATOR=Ninja
}

everything() { (cd source && find . | sort && find . -type f -exec cksum {} + | sort); }

# refused WORDS TEXT: one line that says TEXT, and the checkout is as it was.
refused() {
    everything >before
    # shellcheck disable=SC2086
    expect 2 course new $1
    says err "course: $2"
    is "$1: $(lines err) $(lines out)" "$1: 1 0"
    everything | cmp -s - before || fail "$1: the checkout has changed"
}

test_a_new_chapter_is_whole() {
    expect 0 course new chapter my_topic
    room=chapters/04_my_topic
    for file in $room/about.json $room/chapter.md $room/my_topic.cpp $room/figures.gp $room/study/study.cpp \
        $room/study/figures.gp tests/chapters/04_my_topic.cpp; do
        [ $file = $room/about.json ] || says "source/$file" 'FILL IN'
        says out "  $file "
        is "$file: $(grep -c '' "source/$file" | awk '{print ($1 < 80)}')" "$file: 1"
    done
    ! grep -r NEW_ source/chapters source/tests/chapters || fail 'a word of the template is left'
    is "$(head -n 1 source/$room/chapter.md)" '# My topic {#chapter_04}'
    is "$(sed -n 3p source/README.md | cut -c 1-42)" '| [4 My topic](chapters/04_my_topic) | A b'
    is "$(sed -n 4,5p source/README.md)" '
And so on.'
    says out './course run 4'
    expect 0 course list
    says out '04  My topic'
    # The next one gets the next number.
    expect 0 course new chapter more
    [ -e source/chapters/05_more/more.cpp ] || fail 'no chapter 5'
    is "$(sed -n 4p source/README.md | cut -c 1-27)" '| [5 More](chapters/05_more'
}

test_a_new_exercise_is_whole() {
    for chapter in 3 swing 03_swing; do
        expect 0 course new exercise $chapter place_in_$chapter
    done
    name=place_in_swing
    for file in solutions/03_swing/$name.cpp tests/exercises/03_swing/$name/about.json \
        tests/exercises/03_swing/$name/properties.cpp tests/exercises/03_swing/$name/correct.cpp \
        tests/exercises/03_swing/$name/mistakes.diff; do
        says "source/$file" 'FILL IN'
        is "$file: $(grep -c '' "source/$file" | awk '{print ($1 < 80)}')" "$file: 1"
    done
    ! grep -r NEW_ source/solutions source/tests/exercises source/exercises || fail 'a word of the template is left'
    cmp build/exercises/generated/${name}_stub.cpp source/exercises/03_swing/$name.cpp || fail 'not the stub'
    says source/exercises/03_swing/$name.cpp '    return not_started;  // your answer'
    expect 0 course list
    says out '3.1  velocity_now'
    says out '3.2  place_in_3 '
    says out '3.3  place_in_swing '
    says out '3.4  place_in_03_swing '
}

test_bad_names_are_refused() {
    rule='a name is small letters, digits and single _ between them, and begins with a letter'
    for kind in chapter 'exercise 3'; do
        for name in Topic my-topic 3d _topic topic_ my__topic größe ../topic a.b a/b; do
            refused "$kind $name" "'$name': $rule"
        done
        for name in class namespace co_await learner; do
            refused "$kind $name" "'$name': is a word of C++ or of the checker"
        done
        refused "$kind abcdefghijklmnopqrstuvwxyzabcdefghijklmno" \
            "'abcdefghijklmnopqrstuvwxyzabcdefghijklmno': a name has at most 40 letters"
    done
    refused 'exercise 3 sin' "'sin': is a function of C"
    refused 'exercise 4 topic' "'4' is no chapter; there are 1 fall, 3 swing"
    refused 'chapter swing' "'swing': chapters/03_swing has a program of that name"
    refused 'chapter swing_study' "'swing_study': chapters/03_swing has a program of that name"
    refused 'exercise 1 velocity_now' "'velocity_now': exercise 3.1 has that name"
    expect 2 course new chapter ''
    says err "course: '': $rule"
    for words in '' room chapter 'chapter a b' 'exercise 3' 'exercise 3 a b'; do
        refused "$words" ''
    done
}

# Two targets of one name are more than CMake or Ninja can do.
test_names_that_the_build_has_are_refused() {
    cat >>source/CMakeLists.txt <<'END'
foreach(name my_tool tool_study run_tool check_main ready_exercise_eigen hidden_objects_velocity_now)
  add_custom_target(${name})
endforeach()
install(FILES README.md DESTINATION .)
enable_testing()
include(CPack)
include(tools/cmake/targets.cmake)
timestep_list_targets()
END
    expect 0 course new chapter first
    for kind in chapter 'exercise 3'; do
        refused "$kind my_tool" "'my_tool': is a target of the build, and none may be there twice"
        for name in all test clean help install edit_cache rebuild_cache package package_source; do
            refused "$kind $name" "'$name': is a target that CMake makes itself"
        done
    done
    refused 'chapter tool' "'tool': makes the target tool_study, which the build has already"
    printf 'run_tool\nready_exercise_eigen\nhidden_objects_velocity_now\ncheck_tool\n' >build/targets.txt
    refused 'chapter tool' "'tool': makes the target run_tool, which the build has already"
    for pair in exercise_eigen:ready_exercise_eigen objects_velocity_now:hidden_objects_velocity_now tool:check_tool; do
        refused "exercise 3 ${pair%:*}" "'${pair%:*}': makes the target ${pair#*:}, which the build has already"
    done
}

# Whatever this CMake makes of its own accord.
test_all_that_cmake_makes_itself_is_refused() {
    command -v ninja >/dev/null || exit 77
    printf 'install(FILES README.md DESTINATION .)\nenable_testing()\ninclude(CPack)\n' >>source/CMakeLists.txt
    "$real_cmake" -S source -B empty >/dev/null 2>&1
    ninja -C empty -t targets all | sed 's/: .*//' | grep -x '[a-z_]*' >own
    [ "$(lines own)" -gt 8 ] || fail "Ninja names too few: $(cat own)"
    while read -r name; do
        case $name in fall | swing | docs) continue ;; esac
        expect 2 course new exercise 3 "$name"
        says err "'$name': is a target that CMake makes itself"
    done <own
}

# A function of such a name would stand in the way of what is compiled with it.
test_names_of_the_checker_are_refused() {
    mkdir source/tools/checker
    cp -r "$source"/tools/checker/* source/tools/checker
    for header in "$source"/tools/checker/*.hpp "$source"/tools/checker/learner/*.hpp; do
        name=$(basename "$header" .hpp)
        expect 2 course new exercise 3 "$name"
        says err "course: '$name': is a"
    done
    for name in worker remote truth; do refused "exercise 3 $name" "'$name': is a header of the checker"; done
    # What the headers declare outside of any namespace.
    {
        sed -n 's/^[A-Za-z0-9]* \([a-z_]*\)(.*);$/\1/p' "$source"/tools/checker/learner/*.hpp
        cat "$source"/tools/checker/*.hpp | tr '\n' ' ' | grep -o 'using checker::[^;]*' | grep -o '::[a-zA-Z_]*' | tr -d ':'
    } | grep -x '[a-z_]*' | sort -u >declared
    says declared solve_linear
    says declared draw_moments
    for name in $(cat declared) solution mistakes main; do
        refused "exercise 3 $name" "'$name': is a word of C++ or of the checker"
    done
    refused 'exercise 3 velocity_now_declared' "'velocity_now_declared': names that end in _declared are for what the build"
    refused 'exercise 3 size_t' "'size_t': names that end in _t are the system's, for its types"
}

# CMake has written what Ninja cannot read: it writes again what was there before.
test_what_cannot_be_built_is_taken_back() {
    for kind in chapter 'exercise 3'; do
        echo 1 >build_status
        echo 'ninja: error: build.ninja:7: multiple rules generate topic' >build_says
        : >calls
        refused "$kind topic" "'topic' was not made: ninja: error: build.ninja:7: multiple rules generate topic"
        is "$(grep -c -e '^-S ' calls) $(tail -n 1 calls)" "2 -S $folder/source -B $folder/build"
    done
    echo 0 >build_status
    expect 0 course new chapter topic
}

test_what_the_build_refuses_is_taken_back() {
    refused 'chapter docs' "'docs' was not made: add_custom_target cannot create target \"docs\" because"
    rm source/solutions/03_swing/velocity_now.cpp
    refused 'chapter topic' "'topic' was not made: exercise velocity_now: solutions/03_swing/velocity_now.cpp is missing"
    refused 'exercise 3 topic' "'topic' was not made: exercise velocity_now: solutions/03_swing/velocity_now.cpp is missing"
}

test_nothing_is_half_written() {
    echo 'mine' >source/tests/chapters/04_topic.cpp
    refused 'chapter topic' 'tests/chapters/04_topic.cpp is there already; nothing was made'
    mkdir -p source/exercises/01_fall
    echo 'mine' >source/exercises/01_fall/topic.cpp
    refused 'exercise 1 topic' 'exercises/01_fall/topic.cpp is there already; nothing was made'
    echo 'No table.' >source/README.md
    refused 'chapter other' 'README.md has no table of chapters'
    rm source/README.md
    refused 'chapter other' "$folder/source/README.md: cannot be read"
    echo 'NEW_NAME NEW_WORD.' >source/tools/new/exercise/correct.cpp
    refused 'exercise 3 other' 'source/tools/new/exercise/correct.cpp: nothing stands for NEW_WORD'
    rm source/tools/new/exercise/correct.cpp
    refused 'exercise 3 other' "$folder/source/tools/new/exercise/correct.cpp: cannot be read"
    cp "$source/tools/new/exercise/"*.cpp source/tools/new/exercise
    rm -r source/exercises
    : >source/exercises
    refused 'exercise 3 other' "$folder/source/exercises: cannot be made"
}

# A solution that has changed since CMake last looked.
test_reset_makes_the_file_from_the_solution_as_it_is() {
    for words in velocity_now --all; do
        sed "s/^\/\/ Another player/\/\/ $words: another player/" "$source/solutions/01_derivatives/velocity_now.cpp" \
            >source/solutions/03_swing/velocity_now.cpp
        expect 0 course reset $words
        says source/exercises/03_swing/velocity_now.cpp "// $words: another player"
    done
    sed -i '/answer/d' source/solutions/03_swing/velocity_now.cpp
    expect 2 course reset --all
    is "$(cat err)" "course: solutions/03_swing/velocity_now.cpp: needs two lines // [answer], round what the learner is to write"
}

test_the_learners_edition_makes_none() {
    mkdir source/kit
    echo '{}' >source/kit/kit.json
    refused 'chapter topic' "this is the learner's edition: chapters are added to the whole course"
    refused 'exercise 3 topic' "this is the learner's edition: exercises are added to the whole course"
}

ctest=$6
begin "$@"
new_fixture "$4" "$5"
fixture_for_new
"$function"
