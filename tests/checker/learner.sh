# A learner at work: list, check, hint, solution, reset, watch, and what is remembered.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"
. "$here/fixture.sh"

test_from_stub_to_pass() {
    is "$(state velocity_now)" 'not started'
    expect 1 course check velocity_now
    says out '1.1 velocity_now: not started'
    says out source/exercises/01_derivatives/velocity_now.cpp
    cp "$mistake" $file
    is "$(state velocity_now)" started
    expect 1 course check velocity_now
    says out 'This is the central difference'
    says out 'Hint: '
    expect 1 course solution velocity_now
    says err 'when your own answer has passed'
    cp $solved $file
    expect 0 course check 1.1
    says out '✓ 1.1 velocity_now: right'
    says out 'Next:  1.2 '
    is "$(state velocity_now)" passed
    expect 0 course solution velocity_now
    says out "The course's"
    silent_on out '[answer]'
    expect 0 course list
    says out '✓ 1.1  velocity_now'
    says out '1 of '
}

# The stub of an exercise with an answer in it.
answers() {
    sed "s/return not_started;.*/$2/" "$real_build/exercises/generated/$1_stub.cpp" >answer.cpp
    expect 1 course check "$1" --file answer.cpp --seed 7  # what is drawn decides how much can be told
}

test_is_shown_both_sides_of_a_property() {
    add_chapter 03_euler_variants
    add_chapter 06_stability
    answers longest_parabola_step 'return 4 * zeta \/ omega + 1;'
    says out 'In the long run a step of'
    says out 'multiplies the swing by'
    answers tr_bdf2_step 'return {s.t + h, s.x, s.v};'
    says out 'They differ by'
}

# As the problem matcher of .vscode/tasks.json reads it: where the line N of the file is marked.
marks() {
    sed -n 's/.*"regexp": "\(.*\)",/\1/p' "$source/.vscode/tasks.json" >pattern
    grep -E -f pattern out | sed -E "$(printf 's#%s#\\1 \\3 \\6#' "$(cat pattern)")"
}

test_an_editor_finds_the_line() {
    line=$(grep -n '^double velocity_now(' $file | cut -d: -f1)
    cp "$mistake" $file
    expect 1 course check velocity_now
    is "$(marks)" "$file $(grep -n '^double velocity_now(' $file | cut -d: -f1) error"
    cp "$real_build/exercises/generated/velocity_now_stub.cpp" $file
    sed -i "s/return not_started;.*/\nreturn unheard_of;/" $file
    expect 1 course check velocity_now
    is "$(marks)" "$file $((line + 2)) error"
}

test_a_misspelt_name_gets_the_nearest() {
    for name in velocty_now VelocityNow exercises/01_derivatives/velocity_no.cpp; do
        expect 2 course check $name
        is "$(cat err)" "course: '$name' is no exercise; the nearest is velocity_now (./course list shows them)"
    done
    expect 2 course hint nonsense  # which is near to none
    is "$(cat err)" "course: 'nonsense' is no exercise; ./course list shows them"
}

test_another_file_is_checked_and_not_counted() {
    cp $solved answer.txt
    expect 0 course check velocity_now --file answer.txt
    is "$(state velocity_now)" 'not started'
    expect 2 course check velocity_now --file missing.cpp
    is "$(cat err)" 'course: missing.cpp: cannot be read (No such file or directory)'
}

test_without_a_name_all_that_is_begun_is_checked() {
    expect 1 course check
    says out 'No exercise has been begun'
    cp $solved $file
    second=$(ls source/exercises/01_derivatives/*.cpp | grep -v velocity_now | head -n 1)
    echo 'nonsense' >>"$second"
    expect 1 course check
    says out 'velocity_now                   ✓'
    says out 'does not compile'
    expect 1 course check --json
    says out '"exercise":"velocity_now","verdict":"pass"'
    says out '"verdict":"does_not_compile"'
    is "$(head -c 1 out)" '['
}

test_a_chapter_is_checked() {
    add_chapter 02_first_order_form
    expect 1 course check 1
    is "$(head -n 1 out)" 'No exercise of chapter 1 has been begun. ./course list shows them; the first is'
    cp $solved $file
    echo 'nonsense' >>source/exercises/02_first_order_form/suspension.cpp
    for name in 1 derivatives 01_derivatives; do
        expect 0 course check $name
        says out 'velocity_now                   ✓'
        silent_on out suspension
    done
    expect 2 course check 1 --file $solved
    is "$(cat err)" 'course: check --file needs the exercise that the file answers'
    expect 2 course check 1 --sanitize
    is "$(cat err)" 'course: check --sanitize needs the exercise to check'
    expect 2 course check 4
    is "$(cat err)" "course: '4' is no chapter and no exercise; ./course list shows them"
}

# Who waits is told for what: another ./course, a build, the compiler, the answer itself.
test_what_is_waited_for_is_told() {
    command -v flock >/dev/null || exit 77
    mkdir source/.progress
    for lock in source/.progress/lock build/course.lock; do
        flock --no-fork $lock sleep 1000 &
        holding=$!
        wait_until sh -c "! flock --nonblock $lock true"
        case $lock in *progress*) command=hint ;; *) command=check ;; esac
        start_course $command velocity_now
        trap 'kill $running $holding 2>/dev/null' EXIT
        wait_until grep -q 'Another ./course' said
        kill $holding
        wait $running || true
        says said velocity_now
    done
    own_build "while [ ! -e go ]; do seq 100000 >/dev/null; done; exit 1"
    start_course check velocity_now
    wait_until grep -q 'Waiting for the compiler' said
    : >go
    wait_until grep -q 'does not compile' said
    wait $running || true
    own_build
    { echo '#include <csignal>'; sed 's/return not_started;.*/raise(SIGSTOP); return h;/' $file; } >stopped.cpp
    start_course check velocity_now --file stopped.cpp
    wait_until grep -q 'Waiting for your code' said
    kill $running
    wait $running || true
}

test_hints_come_one_by_one_and_are_remembered() {
    expect 0 course hint velocity_now
    is "$(grep -c 'Hint [0-9] of' out)" 1
    expect 0 course hint velocity_now
    is "$(grep -c 'Hint [0-9] of' out)" 2
    for _ in 1 2 3; do expect 0 course hint velocity_now; done
    says out 'There are no more hints. After a pass:  ./course solution velocity_now'
    says source/.progress/exercises.tsv "$(printf 'velocity_now\topen\t3')"
}

test_reset_keeps_the_answer() {
    cp $solved $file
    expect 0 course check velocity_now
    expect 0 course reset velocity_now
    cmp -s $file build/exercises/generated/velocity_now_stub.cpp || fail 'the file is not the stub'
    cmp -s source/.progress/answers/velocity_now_1.cpp $solved || fail 'the answer is not kept'
    is "$(state velocity_now)" 'not started'
    cp "$mistake" $file
    expect 0 course reset velocity_now
    cmp -s source/.progress/answers/velocity_now_2.cpp "$mistake" || fail 'the second answer is not kept'
    rm $file
    expect 0 course reset velocity_now
    cmp -s $file build/exercises/generated/velocity_now_stub.cpp || fail 'the file did not come back'
}

test_reset_all_keeps_every_answer() {
    cp $solved $file
    expect 0 course check velocity_now
    echo '// begun' >source/exercises/01_derivatives/best_gap.cpp
    rm source/exercises/01_derivatives/extrapolated.cpp
    expect 0 course reset --all
    says out 'The 6 files of exercises/ are as they were at the beginning; 3 of them were not.'
    says out 'One exercise counts no longer as passed'
    cmp -s source/.progress/answers/velocity_now_1.cpp $solved || fail 'the answer is not kept'
    is "$(cat source/.progress/answers/best_gap_1.cpp)" '// begun'
}

test_progress_outlives_a_new_build_and_renamed_chapters() {
    cp $solved $file
    expect 0 course check velocity_now
    for part in source/tests/exercises source/exercises source/solutions source/chapters; do
        mv $part/01_derivatives $part/02_slopes
    done
    is "$(state velocity_now)" passed
}

test_a_torn_progress_file_is_named_and_left_alone() {
    mkdir source/.progress
    printf 'velocity_now\tpassed\t1\nvelo' >source/.progress/exercises.tsv
    cp source/.progress/exercises.tsv before
    for words in list 'hint velocity_now' 'reset velocity_now'; do
        # shellcheck disable=SC2086
        expect 2 course $words
        says err 'exercises.tsv:2: '
        says err 'Delete the line or the file; ./course check then marks the exercises that pass again'
        is "$(lines err)" 1
    done
    cmp -s before source/.progress/exercises.tsv || fail 'the file was changed'
}

test_watch_checks_whenever_the_file_is_saved() {
    start_course watch velocity_now
    wait_until grep -qF 'velocity_now: not started' said
    cp "$mistake" $file
    wait_until grep -qF 'This is the central difference' said
    cp $solved $file
    wait_until grep -qF 'velocity_now: right' said
    # Another than the one that comes next.
    grep -F 'order_of_results' said && fail 'it was checked unasked'
    cp "$source/solutions/01_derivatives/order_of_results.cpp" source/exercises/01_derivatives
    wait_until grep -qF 'order_of_results: right' said
    kill $running
    is "$(state velocity_now)" passed
}

program=$4 real_build=$5
begin "$@"
new_fixture
"$function"
