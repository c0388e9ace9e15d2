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
    is "$(cat err)" "course: '--step': the numbers to change stand at the top of chapters/03_swing/swing.cpp; \
the study takes options: ./course run 3 --study -- --step"
}

test_study_leaves_everything_and_shows_the_output() {
    expect 0 course run 3 --study --out made/for/me
    says out 'The output, with'
    says out "Data, numbers and figures: $folder/made/for/me"
    is "$(cd made/for/me && ls -A | tr '\n' ' ')" \
        'motion.dat motion.tsv numbers.tsv program.txt run.txt seconds.txt swing.svg '
    # Again, beside files of the reader's own, which stay.
    echo mine >made/for/me/mine.tsv
    echo old >made/for/me/motion.tsv
    expect 0 course run 3 --study --out made/for/me
    is "$(cat made/for/me/mine.tsv)" mine
    silent_on made/for/me/motion.tsv old
}

test_a_chapter_without_a_study_says_so() {
    rm -r source/chapters/03_swing/study
    expect 0 course run 3
    expect 2 course run 3 --study
    is "$(cat err)" 'course: --study: 03_swing has no study'
}

test_a_chapter_has_four_names_and_its_files() {
    for name in 03 swing 03_swing chapters/03_swing/study/study.cpp; do
        expect 0 course run $name
        says out "Its picture: $folder/build/runs/03_swing/swing.svg"
    done
    expect 2 course run 17
    is "$(cat err)" "course: '17' is no chapter; there are 1 fall, 3 swing"
}

test_options_reach_the_study_as_they_are() {
    expect 0 course run 3 --study -- --step 0.1 'two words' 'a;b' --all
    says out 'The output, with <--step> <0.1> <two words> <a;b> <--all>'
    expect 0 course run 3 --study -- --help
    is "$(cat out)" 'the options of this chapter'
    expect 2 course run 3 --study -- --step ''
    is "$(cat err)" "course: '': there is an empty word after the --"
    expect 2 course run 3 --study -- --out there
    is "$(cat err)" 'course: --out belongs before the --: ./course run 3 --study --out DIR -- OPTIONS'
    expect 2 course run 03_swing --study -- --odd
    is "$(cat err)" \
        'course: swing: --odd: unknown option (./course run 03_swing --study -- --help lists them)'
}

# fails STATUS OPTION TEXT: the study's option makes the run fail, the one line says TEXT, and nothing is left.
fails() {
    expect "$1" course run 3 --study --out old/new -- "$2"
    says err "course: $3"
    is "$(lines err)" 1
    is "$(ls -A old)" ''
    ! ls build | grep complaint || fail 'a complaint was left'
}

test_what_fails_is_one_line_and_leaves_nothing() {
    mkdir old
    fails 2 --bad 'swing: --bad: must be good'
    fails 1 --wrong 'swing: does not hold: up is up'
    fails 1 --crash "$folder/build/chapters/swing_study: "
    fails 2 --full "swing: $folder/old/new/motion.tsv: cannot be written"
    fails 2 --blocked ''  # CMake itself cannot write the output
    says err "$folder/old/new/run.txt"
    : >draws_nothing
    expect 2 course run 3 --out old/new
    says err 'swing.svg was not drawn'
    : >gnuplot_complains
    expect 2 course run 3 --out old/new
    says err 'undefined variable: styel'
    is "$(ls -A old)" ''
}

test_what_does_not_hold_with_other_options_is_said() {
    expect 0 course run 3 --study --out new -- --doubt
    is "$(cat err)" "swing: with these options the following, true with the page's options, does not hold:
  up is up"
    [ -e new/motion.tsv ] || fail 'nothing was kept'
}

test_a_folder_that_cannot_be_written_is_named() {
    : >file
    expect 2 course run 3 --out file/below
    is "$(cat err)" 'course: --out file/below: cannot write there (Not a directory)'
    expect 2 course run 3 --out ''
    is "$(cat err)" "course: --out '': must be the name of a folder"
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
