# Tests of `course run`: one chapter, its files in the reader's folder, and never a part of them.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

test_run_is_the_short_program_and_its_picture() {
    expect 0 course run 3 --out made/for/me
    is "$(head -n 1 out)" 'What the program says'
    says out "Its picture: $folder/made/for/me/swing.svg"
    says out 'The program: chapters/03_swing/swing.cpp'
    is "$(cd made/for/me && echo *)" 'motion.dat program.txt seconds.txt swing.svg'
    says calls '--target swing'
    silent_on calls swing_study
    # It has no options: its numbers stand in its source.
    expect 2 course run 3 -- --step 0.1
    says err "course: '--step': the numbers to play with stand at the top of chapters/03_swing/swing.cpp"
    says err './course run 3 --study -- --step'
}

test_study_leaves_everything_and_shows_the_output() {
    expect 0 course run 3 --study --out made/for/me
    says out 'The output, with'
    says out "Data, numbers and figures: $folder/made/for/me"
    is "$(cd made/for/me && echo *)" \
        'motion.dat motion.tsv numbers.tsv program.txt run.txt seconds.txt swing.svg'
    is "$(ls -A made/for/me | lines /dev/stdin)" 7
    says calls '--target swing swing_study'
    # Again, beside files of the reader's own, which stay.
    echo mine >made/for/me/mine.tsv
    echo old >made/for/me/motion.tsv
    expect 0 course run 3 --study --out made/for/me
    is "$(cat made/for/me/mine.tsv)" mine
    silent_on made/for/me/motion.tsv old
}

test_what_is_in_the_readers_folder_stays() {
    mkdir -p there/.unfinished there/.unfinished_run
    echo mine >there/.unfinished/mine
    echo mine >there/.unfinished_run/mine
    for _ in 1 2; do
        expect 0 "$real_cmake" -DPROGRAM="$folder/build/chapters/swing" -DOUT="$folder/there" \
            -DROOM="$folder/source/chapters/03_swing" -DSTYLE=style.gp -DGNUPLOT="$folder/bin/gnuplot" \
            -P "$folder/source/tools/cmake/run.cmake"
        expect 0 course run 3 --out there
    done
    is "$(cat there/.unfinished/mine there/.unfinished_run/mine)" "$(printf 'mine\nmine')"
    is "$(echo there/.unfinished*)" 'there/.unfinished there/.unfinished_run'
}

test_a_chapter_has_four_names_and_its_files() {
    for name in 3 03 swing 03_swing chapters/03_swing chapters/03_swing/ chapters/03_swing/study/study.cpp; do
        expect 0 course run $name
        says out "Its picture: $folder/build/runs/03_swing/swing.svg"
    done
    for name in 2 33 3x swin '' 0 -3 chapters chapters/ chapters/03_swi chapters/03_swings; do
        expect 2 course run "$name"
        is "$(lines err)" 1
        is "$(lines out)" 0
    done
    expect 2 course run 17
    is "$(cat err)" "course: '17' is no chapter; there are 1 fall, 3 swing"
}

test_options_reach_the_chapters_program_as_they_are() {
    expect 0 course run 3 --study -- --step 0.1 'two words' 'a;b' --all
    says out 'The output, with <--step> <0.1> <two words> <a;b> <--all>'
    expect 2 course run 3 --study -- --step ''
    is "$(cat err)" "course: '': there is an empty word after the --"
}

test_help_of_the_chapters_program() {
    expect 0 course run 3 --study -- --help
    is "$(cat out)" 'the options of this chapter'
    [ ! -e build/runs ] || fail 'something was left'
}

test_what_a_program_refuses_is_one_line_and_status_2() {
    expect 2 course run 3 --study --out new -- --bad
    is "$(cat err)" 'course: swing: --bad: must be good'
    [ ! -e new ] || fail 'something was left'
    is "$(lines err)" 1
    expect 2 course run 3 --study -- --value
    is "$(cat err)" 'course: swing: --value: needs a value'
    expect 2 course run 03_swing --study -- --odd
    is "$(cat err)" \
        'course: swing: --odd: unknown option (./course run 03_swing --study -- --help lists them)'
    expect 2 course run 3 --study -- --out there
    is "$(cat err)" 'course: --out belongs before the --: ./course run 3 --study --out DIR -- OPTIONS'
}

test_a_wrong_check_is_status_1() {
    expect 1 course run 3 --study --out new -- --wrong
    is "$(cat err)" 'course: swing: does not hold: up is up'
    [ ! -e new ] || fail 'something was left'
}

test_what_does_not_hold_with_other_options_is_said() {
    expect 0 course run 3 --study --out new -- --doubt
    is "$(cat err)" "swing: with these options the following, true with the page's options, does not hold:
  up is up"
    [ -e new/motion.tsv ] || fail 'nothing was kept'
}

test_a_program_that_crashes_is_named() {
    expect 1 course run 3 --study --out new -- --crash
    says err 'course: '
    says err 'swing_study: '
    [ ! -e new ] || fail 'something was left'
}

test_figures_that_fail_leave_nothing() {
    mkdir old
    : >gnuplot_complains
    expect 2 course run 3 --out old/new
    says err 'undefined variable: styel'
    rm gnuplot_complains
    : >draws_nothing
    expect 2 course run 3 --out old/new
    says err 'swing.svg was not drawn'
    is "$(ls -A old)" ''
}

test_a_folder_that_cannot_be_written_is_named() {
    : >file
    expect 2 course run 3 --out file
    is "$(cat err)" 'course: --out file: cannot write there (Not a directory)'
    expect 2 course run 3 --out file/below
    is "$(cat err)" 'course: --out file/below: cannot write there (Not a directory)'
    [ ! -d /proc/self ] || {
        expect 2 course run 3 --out /proc/self/new/one
        is "$(sed 's/(.*//' err)" 'course: --out /proc/self/new/one: cannot write there '
    }
    expect 2 course run 3 --out ''
    is "$(cat err)" "course: --out '': must be the name of a folder"
}

test_a_file_that_cannot_be_written_has_the_readers_name() {
    expect 2 course run 3 --study --out new -- --full
    is "$(cat err)" "course: swing: $folder/new/motion.tsv: cannot be written"
    [ ! -e new ] || fail 'something was left'
    # Here CMake itself cannot write the output.
    expect 2 course run 3 --study --out new -- --blocked
    says err "$folder/new/run.txt"
    silent_on err 'CMake Error'
    [ ! -e new ] || fail 'something was left'
    is "$(lines err)" 1
    ! ls build | grep complaint || fail 'a complaint was left'
    # And here a folder of the reader's own is in the way.
    mkdir -p there/program.txt
    expect 2 course run 3 --out there
    says err program.txt
}

test_a_build_that_fails_is_status_1() {
    printf 'FAILED: swing\nc++ swing\nswing.cpp:3: no\n' >build_says
    echo 1 >build_status
    expect 1 course run 3 --out new
    is "$(head -n 1 err)" 'swing.cpp:3: no'
    [ ! -e new ] || fail 'something was left'
}

test_an_interrupted_run_leaves_nothing() {
    command -v setsid >/dev/null || exit 77
    cat >interrupted.sh <<END
trap : INT
. '$here/fixture.sh'
folder=$folder program=$program ctest=$ctest
course run 3 --study --out new -- --interrupt
echo "status \$?" >status
END
    setsid -w sh interrupted.sh >out 2>err </dev/null
    is "$(cat status)" 'status 130'
    [ ! -e new ] || fail 'something was left'
}

ctest=$6
begin "$@"
new_fixture "$4" "$5"
"$function"
