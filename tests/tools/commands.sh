# Tests of the course program: what it accepts, list, tour and site.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

test_bad_use_is_one_line_and_status_2() {
    for words in '' turo '--json' 'list --jsn' 'list 3' 'run' 'run 3 4' 'run 3 --out' 'tour -- --step' 'hint' 'solution' 'reset' 'check --sed 3' 'check 1.1 1.2' \
        advise 'advise --omega nan' 'bench lattency' 'bench --scene' 'bench loops --quick' 'bench latency --rounds 0' 'bench latency --rounds many' 'kit' 'kit there --with-solution' '--with-solutions'; do
        # shellcheck disable=SC2086
        expect 2 course $words
        is "$(lines err)" 1
        is "$(lines out)" 0
        is "$(sed 's/course: .*/course/' err)" course
    done
    expect 2 course ''
    is "$(lines err)" 1
    expect 2 course list --jsn
    says err '--jsn'
    expect 2 course run
    says err 'CHAPTER is required (./course run --help)'
    expect 2 course bench lattency
    says err "bench has no 'lattency'; there are loops, "
    expect 2 course advise --omega abc
    says err '--omega = abc: it takes numbers (./course advise --help)'
    expect 2 course run 3 --omega 20
    is "$(cat err)" "course: run has no option --omega; those of the chapter's study go after --: \
./course run 3 --study -- --omega 20"
    expect 2 course run 3 4
    silent_on err "chapter's own"
    expect 2 course tour -- --step
    says err "course: only run takes options for a chapter's program after --"
}

# The words are our own, not those of the library that reads options.
test_bad_use_is_told_in_our_words() {
    while IFS='|' read -r words told; do
        # shellcheck disable=SC2086
        expect 2 course $words
        is "$words: $(cat err)" "$words: course: $told"
    done <<'END'
new chapter -x|new chapter has no option -x (./course new chapter --help)
list 3|list does not take '3' (./course list --help)
check --sed 3|check has no option --sed (./course check --help)
new|new takes chapter or exercise (./course new --help)
--json|./course has no option --json (./course --help)
bench --scene|--scene needs a value, NAME (./course bench --help)
advise --spin 1,2|--spin needs 3 values, with commas between (./course advise --help)
list --json=maybe|--json takes no value (./course list --help)
bench latency --rounds many|--rounds many: must be a whole number from 1 to 1000 (./course bench latency --help)
site --pdf --open|--open and --pdf do not go together (./course site --help)
END
    mkdir -p source/tests/exercises
    cp -r "${source_of_door%/course}/tests/exercises/01_derivatives" source/tests/exercises
    for command in hint solution reset watch; do
        expect 2 course $command 1
        is "$(cat err)" "course: '1' is a chapter; its exercises are 1.1, 1.2, 1.3, 1.4, 1.5, 1.6"
    done
    expect 2 course check 9
    is "$(cat err)" "course: '9' is no chapter and no exercise; ./course list shows them"
}

test_a_scene_that_is_not_there_is_refused_before_anything_is_built() {
    mkdir -p source/tools/bench/contest source/engines/measure
    cp "${source_of_door%/course}/tools/bench/contest/scenes.hpp" source/tools/bench/contest
    cp "${source_of_door%/course}/engines/measure/engines.cpp" source/engines/measure
    : >calls
    expect 2 course bench --scene nosuch
    is "$(cat err)" "course: --scene 'nosuch': must be one of projectile, drag, spring, damped_spring, spring_3d, stiff_spring, \
two_time_scales, bouncing_ball, dzhanibekov, symmetric_top, capsule_on_plane"
    expect 2 course bench engines --scene nosuch
    is "$(cat err)" "course: --scene 'nosuch': must be one of alone, top, throws, piles, cost"
    is "$(lines calls)" 0
}

test_every_command_has_a_help_and_stands_in_the_doors() {
    expect 0 course --help
    for command in tour test list run where check watch hint reset new grade advise bench kit site; do
        says out "  $command "
        expect 0 course $command --help
        says out "Usage: ./course $command"
        grep -q "^  ./course $command " "$source_of_door" || fail "the door's help lacks $command"
        expect 0 course --help
    done
    is "$(sed -n '/^Subcommands/,$p' out | grep -c '^  [a-z]')" 16
}

test_the_help_says_what_kit_and_check_take() {
    expect 0 course kit --help
    says out '--with-solutions'
    expect 0 course check --help
    says out 'a chapter'
    says "$source_of_door" './course check 5 '
    says "$source_of_door" '--with-solutions'
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

test_chapters_come_in_the_order_of_their_numbers() {
    for number in 19 07 12 05 16 02 11; do
        new_chapter ${number}_more "Number $number" more.svg '[]'
    done
    expect 0 course list
    is "$(grep -o '^[0-9][0-9]' out | tr '\n' ' ')" '01 02 03 05 07 11 12 16 19 '
}

test_list_json_is_for_programs() {
    expect 0 course list --json
    cat >look.cmake <<'END'
file(READ out json)
string(JSON count LENGTH "${json}" chapters)
string(JSON name GET "${json}" chapters 1 chapter)
string(JSON title GET "${json}" chapters 1 title)
string(JSON program GET "${json}" chapters 1 program)
string(JSON figure GET "${json}" chapters 1 figures 0)
string(JSON claims GET "${json}" chapters 0 claims)
message("${count} ${name}, ${title}, ${program}, ${figure} ${claims}")
END
    is "$("$real_cmake" -P look.cmake 2>&1)" \
        '2 03_swing, A spring swings, swing, swing.svg [ "N01", "N02" ]'
    expect 0 course list --json --yes
    silent_on out 'course:'
}

test_a_broken_about_json_is_named() {
    echo '{"title": 3' >source/chapters/03_swing/about.json
    expect 2 course list
    says err "course: $folder/source/chapters/03_swing/about.json: "
    echo '{"title": "x"}' >source/chapters/03_swing/about.json
    expect 2 course list --json
    says err "about.json"
    says err "question"
    is "$(lines out)" 0
}

test_a_full_standard_output_is_no_success() {
    [ -e /dev/full ] || exit 77
    got=0
    course list >/dev/full 2>err </dev/null || got=$?
    is "$got" 2
    says err 'course: standard output: cannot be written'
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

test_on_a_terminal_tour_shows_that_it_goes_on() {
    command -v script >/dev/null || exit 77
    printf '[1/2] Building CXX object a.cpp.o\n[2/2] Running chapter 03_swing\n' >build_says
    : >build_pauses
    cat >on_terminal.sh <<END
. '$here/fixture.sh'
folder=$folder program=$program ctest=$ctest
course tour
END
    script -qec 'sh on_terminal.sh' /dev/null >out </dev/null || fail "exit status $?"
    tr '\r' '\n' <out >err
    # How many seconds, that is the machine's own; but they go on.
    grep -q '[0-9] s  \[1/2\] Building CXX object a.cpp.o' err || fail 'it does not show the seconds'
    says err '  Running chapter 03_swing'
    grep -q '[1-9][0-9]* s  \[2/2\]' err || fail 'the seconds do not go on'
    silent_on err '[2/2] Running'
    says err "$(printf '\033[1mchapter')"
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

test_tour_does_not_invent_a_time() {
    for time in soon '3 s' ''; do
        echo "$time" >build/chapters/03_swing/run/seconds.txt
        expect 1 course tour
        says err 'run/seconds.txt: does not hold a time in ms'
    done
}

test_site_gives_an_address_that_a_browser_takes() {
    mv build 'the build'
    ln -s 'the build' build
    expect 0 env FIXTURE_SOURCE="$folder/source" FIXTURE_BUILD="$folder/the build" \
        FIXTURE_CMAKE="$folder/bin/fixture_cmake" "$program" site
    is "$(cat out)" "file://$folder/the%20build/site/html/index.html"
    says calls docs
}

test_site_opens_where_it_is_asked_to() {
    fake_browser 0
    expect 0 course site
    [ ! -e opened ] || fail 'opened without being asked'
    expect 0 course site --open
    is "$(cat opened)" "file://$folder/build/site/html/index.html"
    fake_browser 1
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
    expect 2 course site --pdf --open
    says err '--open'
}

test_an_interrupt_reaches_what_runs_and_ends_the_command() {
    command -v setsid >/dev/null || exit 77
    printf '#!/bin/sh\nkill -INT 0\nsleep 3\n' >bin/xdg-open
    chmod +x bin/xdg-open
    cat >interrupted.sh <<END
trap : INT
. '$here/fixture.sh'
folder=$folder program=$program ctest=$ctest
course site --open
echo "status \$?" >status
END
    setsid -w sh interrupted.sh >out 2>err </dev/null
    is "$(cat status)" 'status 130'
}

fake_browser() {
    printf '#!/bin/sh\necho "$1" >"%s/opened"\nexit %s\n' "$folder" "$1" >bin/xdg-open
    chmod +x bin/xdg-open
}

source_of_door=$3/course
ctest=$6
begin "$@"
new_fixture "$4" "$5"
"$function"
