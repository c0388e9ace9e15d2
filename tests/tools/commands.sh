# Tests of the course program: what it accepts, list, tour and site.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

test_bad_use_is_one_line_and_status_2() {
    while IFS='|' read -r words told; do
        # shellcheck disable=SC2086
        expect 2 course $words
        is "$words: $(cat err)" "$words: course: $told"
        is "$(lines out)" 0
    done <<'END'
--json|A subcommand is required (./course --help)
list 3|The following argument was not expected: 3 (./course list --help)
list --json=maybe|Could not convert: --json = maybe (./course list --help)
check --sed 3|The following argument was not expected: --sed (./course check --help)
run|CHAPTER is required (./course run --help)
run 3 --omega 20|run has no option --omega; those of the chapter's study go after --: ./course run 3 --study -- --omega 20
tour -- --step|only run takes options for a chapter's program after --
bench --scene|--scene: 1 required NAME missing (./course bench --help)
advise --spin 1,2|--spin: At least 3 required but received 2 (./course advise --help)
grade class --jobs 0|--jobs: Value 0 not in range 1 to 256 (./course grade --help)
site --pdf --open|--open excludes --pdf (./course site --help)
END
    mkdir -p source/tests/exercises
    cp -r "${source_of_door%/course}/tests/exercises/01_derivatives" source/tests/exercises
    expect 2 course hint 1
    is "$(cat err)" "course: '1' is a chapter; its exercises are 1.1, 1.2, 1.3, 1.4, 1.5, 1.6"
    expect 2 course check 9
    is "$(cat err)" "course: '9' is no chapter and no exercise; ./course list shows them"
}

test_every_command_has_a_help_and_stands_in_the_doors() {
    expect 0 course --help
    is "$(sed -n '/^Subcommands/,$p' out | grep -c '^  [a-z]')" 16
    for command in tour test list run where check watch hint reset new grade advise bench kit site; do
        expect 0 course $command --help
        says out "Usage: ./course $command"
        grep -q "^  ./course $command " "$source_of_door" || fail "the door's help lacks $command"
    done
}

test_list_shows_title_and_question_in_order() {
    mkdir source/chapters/my_notes source/chapters/1x_notes source/chapters/x1_notes
    expect 0 course list
    is "$(grep -v '^$' out)" '01  A body falls
    Why?
    ./course run 1   chapters/01_fall
03  A spring swings
    Why?
    ./course run 3   chapters/03_swing'
}

test_list_json_is_for_programs() {
    expect 0 course list --json
    for field in '1 chapter' '1 title' '1 program' '1 figures 0' '0 claims 1'; do
        echo "string(JSON word GET \"\${json}\" chapters $field)
list(APPEND words \${word})"
    done >look.cmake
    printf 'file(READ out json)\n%s\nmessage("${words}")\n' "$(cat look.cmake)" >look.cmake
    is "$("$real_cmake" -P look.cmake 2>&1)" '03_swing;A spring swings;swing;swing.svg;N02'
    expect 0 course list --json --yes
    silent_on out 'course:'
}

test_a_broken_about_json_is_named() {
    echo '{"title": "x"}' >source/chapters/03_swing/about.json
    expect 2 course list --json
    says err "course: $folder/source/chapters/03_swing/about.json: "
    says err "picture"
    is "$(lines out)" 0
}

test_tour_shows_its_stages_and_closes_with_the_table() {
    new_chapter 04_angle 'Angle φ' 'angle.svg' '[]'
    cat >build_says <<'END'
[1/4] Building CXX object a.cpp.o
[2/4] Linking CXX executable swing
[3/4] Running chapter 03_swing
[4/4] Making the site with Doxygen
END
    expect 0 course tour
    says err '  Running chapter 03_swing'
    says err '  Making the site with Doxygen'
    silent_on err 'Building CXX'
    cmp -s build_says build/course.log || fail 'course.log is not what the build said'
    says calls "--build $folder/build"
    says calls docs
    is "$(cat out)" "chapter   title            seconds  figures  claims of the talks
01_fall   A body falls        1.23        1                  2
03_swing  A spring swings     1.23        1                  1
04_angle  Angle φ             1.23        1                  0
all                           3.70        3                  3

The site: file://$folder/build/site/html/index.html
Next: open it in a browser; ./course list shows the exercises"
    # Where there is no site yet, the first chapter comes first, and then one after the other.
    is "$(sed -n 's/.*--target //p' calls | tr '\n' ';')" \
        'first_chapter;grow_03_swing angle;grow_04_angle;docs;'
    : >build/site/html/made
    : >calls
    expect 0 course tour
    is "$(sed -n 's/.*--target //p' calls)" docs
}

test_tour_that_fails_says_why_without_a_table() {
    cat >build_says <<'END'
[1/4] Building CXX object a.cpp.o
FAILED: chapters/03_swing/run/done
cd /somewhere && a very long command
CMake Error at run.cmake:23 (message):
  swing: does not hold: up is up
[2/4] Building CXX object b.cpp.o
ninja: build stopped: subcommand failed.
END
    echo 1 >build_status
    expect 1 course tour
    is "$(sed -n 2,3p err)" 'CMake Error at run.cmake:23 (message):
  swing: does not hold: up is up'
    is "$(lines err)" 4
    says err "course: the build failed; the lines above say why, the whole log is in $folder/build/course.log"
    is "$(lines out)" 0
}

test_site_gives_an_address_and_opens_it_if_asked_to() {
    mv build 'the build'
    ln -s 'the build' build
    printf '#!/bin/sh\necho "$1" >"%s/opened"\n' "$folder" >bin/xdg-open
    chmod +x bin/xdg-open
    for words in site 'site --open'; do
        [ ! -e opened ] || fail 'opened without being asked'
        # shellcheck disable=SC2086
        expect 0 env FIXTURE_SOURCE="$folder/source" FIXTURE_BUILD="$folder/the build" PATH="$folder/bin:$PATH" \
            FIXTURE_CMAKE="$folder/bin/fixture_cmake" "$program" $words
        is "$(cat out)" "file://$folder/the%20build/site/html/index.html"
    done
    is "$(cat opened)" "$(cat out)"
    says calls docs
    printf '#!/bin/sh\nexit 1\n' >bin/xdg-open
    expect 3 course site --open
    says err 'course: xdg-open found no browser; open the address above in one'
}

test_site_prints_a_book_where_a_browser_can() {
    expect 3 course site --pdf
    says err "course: --pdf: no browser that prints was found (package chromium); to print by hand: file://$folder/build/site/book.html"
    says calls book
    : >build/site/timestep.pdf
    expect 0 course site --pdf
    is "$(cat out)" "file://$folder/build/site/timestep.pdf"
}

source_of_door=$3/course
ctest=$6
begin "$@"
new_fixture "$4" "$5"
"$function"
