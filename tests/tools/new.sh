# Tests of `course new`: a chapter or an exercise is made whole, or nothing is.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

# A checkout that CMake can configure: chapters are targets, exercises are read as in earnest.
fixture_for_new() {
    mkdir -p source/tests/chapters source/tests/exercises/03_swing source/solutions/03_swing source/exercises/03_swing
    cp -r "$source/tools/new" source/tools
    printf '| chapter | the question |\n|---|---|\n| [1 A body falls](chapters/01_fall) | Why? |\n\nAnd so on.\n' >source/README.md
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

# refused WORDS TEXT: the last line says TEXT, and the checkout is as it was.
refused() {
    everything >before
    # shellcheck disable=SC2086
    expect 2 course new $1
    tail -n 1 err >last
    says last "course: $2"
    everything | cmp -s - before || fail "$1: the checkout has changed"
}

# made FILE…: they have what is to be filled in, and no word of a template.
made() {
    for file; do
        says out "  $file "
        [ "${file##*/}" = about.json ] || says "source/$file" 'FILL IN'
        silent_on "source/$file" NEW_
    done
}

test_a_new_chapter_is_four_files_and_a_row_of_the_readme() {
    expect 0 course new chapter my_topic
    room=chapters/04_my_topic
    made $room/about.json $room/chapter.md $room/my_topic.cpp $room/figures.gp
    is "$(find source/$room -type f | grep -c '')" 4
    is "$(head -n 1 source/$room/chapter.md)" '# My topic {#chapter_04}'
    is "$(sed -n 3,7p source/README.md | sed 's/A ball.*?/A ball?/')" '| [1 A body falls](chapters/01_fall) | Why? |
| [3 A spring swings](chapters/03_swing) | Why? |
| [4 My topic](chapters/04_my_topic) | A ball? |

And so on.'
    says calls '--target my_topic'
    expect 0 course list
    says out '04  My topic'
}

test_with_all_a_new_chapter_has_its_optional_parts() {
    expect 0 course new chapter my_topic --all
    room=chapters/04_my_topic
    made $room/chapter.md $room/study/study.cpp $room/study/figures.gp $room/live/my_topic.cpp tests/chapters/04_my_topic.cpp
    says source/$room/chapter.md '{{check half_the_error}}'
}

test_a_new_exercise_is_whole() {
    expect 0 course new exercise swing one_more
    cmp build/exercises/generated/one_more_stub.cpp source/exercises/03_swing/one_more.cpp || fail 'not the stub'
    says source/exercises/03_swing/one_more.cpp '    return not_started;  // your answer'
    room=tests/exercises/03_swing/one_more
    made solutions/03_swing/one_more.cpp $room/about.json $room/properties.cpp $room/correct.cpp $room/mistakes.diff
    expect 0 course list
    says out '3.2  one_more '
}

test_bad_names_are_refused() {
    rule='a name is small letters, digits and single _ between them, and begins with a letter'
    for kind in chapter 'exercise 3'; do
        for name in Topic 3d topic_ my__topic größe; do
            refused "$kind $name" "'$name': $rule"
        done
        refused "$kind abcdefghijklmnopqrstuvwxyzabcdefghijklmno" \
            "'abcdefghijklmnopqrstuvwxyzabcdefghijklmno': a name has at most 40 letters"
    done
    refused 'exercise 4 topic' "'4' is no chapter; there are 1 fall, 3 swing"
    refused 'chapter swing' "'swing': chapters/03_swing has that name"
    refused 'exercise 1 velocity_now' "'velocity_now': exercise 3.1 has that name"
}

test_what_the_build_refuses_is_taken_back() {
    refused 'chapter docs' "'docs' was not made: add_custom_target cannot create target \"docs\" because"
    echo 1 >build_status
    echo 'ninja: error: build.ninja:7: multiple rules generate topic' >build_says
    : >calls
    refused 'exercise 3 topic' "'topic' was not made: the build failed"
    says err 'multiple rules generate topic'
    is "$(tail -n 1 calls)" "-S $folder/source -B $folder/build"  # CMake writes again what there was before
    rm source/solutions/03_swing/velocity_now.cpp
    refused 'chapter topic' "'topic' was not made: exercise velocity_now: solutions/03_swing/velocity_now.cpp is missing"
}

test_nothing_is_half_written() {
    mkdir -p source/tests/chapters
    echo 'mine' >source/tests/chapters/04_topic.cpp
    refused 'chapter topic --all' 'tests/chapters/04_topic.cpp is there already; nothing was made'
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

ctest=$6
begin "$@"
new_fixture "$4" "$5"
fixture_for_new
"$function"
