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
    is "$(lines out)" 0
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

test_an_exercise_has_a_name_a_number_and_a_file() {
    cp "$mistake" $file
    for name in velocity_now 1.1 $file "$folder/$file"; do
        expect 1 course check "$name" --json
        says out '"exercise":"velocity_now","verdict":"wrong"'
        is "$(lines out)" 1
    done
    expect 2 course check velocty_now
    is "$(cat err)" "course: 'velocty_now' is no exercise; ./course list shows them"
}

test_json_says_just_what_programs_need() {
    cp "$mistake" $file
    expect 1 course check velocity_now --json --seed 7
    is "$(sed 's/"seconds":[0-9.]*/"seconds":S/' out)" '{"exercise":"velocity_now","verdict":"wrong",'\
'"property":"a constant acceleration gives exactly the velocity at the newest frame",'\
'"misconception":"middle","seed":7,"seconds":S}'
}

test_a_seed_repeats_a_check() {
    cp "$mistake" $file
    expect 1 course check velocity_now --seed 7
    grep -A2 'after the call' out >first
    expect 1 course check velocity_now --seed 7
    grep -A2 'after the call' out | cmp -s - first || fail 'the same seed draws other numbers'
    expect 1 course check velocity_now --seed 8
    ! grep -A2 'after the call' out | cmp -s - first || fail 'another seed draws the same numbers'
    for seed in -1 1.5 seven '' 99999999999999999999999; do
        expect 2 course check velocity_now "--seed=$seed"
        is "$(lines err)" 1
    done
}

test_another_file_is_checked_and_not_counted() {
    cp $solved answer.txt
    expect 0 course check velocity_now --file answer.txt
    is "$(state velocity_now)" 'not started'
    expect 2 course check velocity_now --file missing.cpp
    is "$(cat err)" 'course: missing.cpp: cannot be read (No such file or directory)'
    expect 2 course check velocity_now --file source
    is "$(cat err)" 'course: source: cannot be read (it is a folder)'
    expect 2 course check --file answer.txt
    is "$(lines err)" 1
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

test_hints_come_one_by_one_and_are_remembered() {
    expect 0 course hint velocity_now
    is "$(grep -c 'Hint [0-9] of' out)" 1
    expect 0 course hint velocity_now
    is "$(grep -c 'Hint [0-9] of' out)" 2
    for _ in 1 2 3; do expect 0 course hint velocity_now; done
    says out 'There are no more hints'
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
    expect 2 course reset --all velocity_now
    cmp -s $file $solved || fail 'refused, and yet reset'
    expect 0 course reset --all
    says out 'The 6 files of exercises/ are as they were at the beginning; 3 of them were not.'
    for unsolved in source/exercises/01_derivatives/*.cpp; do
        name=$(basename "$unsolved" .cpp)
        cmp -s "$unsolved" "build/exercises/generated/${name}_stub.cpp" || fail "$name is not the stub"
        is "$(state "$name")" 'not started'
    done
    is "$(ls source/exercises/01_derivatives/*.cpp | grep -c '')" 6
    cmp -s source/.progress/answers/velocity_now_1.cpp $solved || fail 'the answer is not kept'
    is "$(cat source/.progress/answers/best_gap_1.cpp)" '// begun'
    is "$(ls source/.progress/answers | grep -c '')" 2
    expect 0 course reset --all
    says out '; 0 of them were not.'
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
        is "$(lines err)" 1
    done
    cmp -s before source/.progress/exercises.tsv || fail 'the file was changed'
}

test_watch_checks_whenever_the_file_is_saved() {
    FIXTURE_SOURCE=$folder/source FIXTURE_BUILD=$folder/build FIXTURE_CMAKE=true FIXTURE_CTEST=false \
        "$program" watch velocity_now >watched 2>&1 &
    watching=$!
    wait_for() {
        for _ in $(seq 6000); do
            ! grep -qF "$1" watched || return 0
            sleep 0.1
        done
        kill $watching
        fail "watch does not say: $1"
    }
    wait_for 'velocity_now: not started'
    cp "$mistake" $file
    wait_for 'This is the central difference'
    cp $solved $file
    wait_for 'velocity_now: right'
    wait_for 'Watching source/exercises/01_derivatives/'
    kill $watching
    is "$(state velocity_now)" passed
}

program=$4 real_build=$5
begin "$@"
new_fixture
"$function"
