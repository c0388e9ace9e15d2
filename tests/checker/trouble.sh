# A learner in trouble: files that are gone, odd or huge, interrupts, a full disk, two commands at once.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"
. "$here/fixture.sh"

test_a_deleted_file_comes_back_by_reset() {
    rm $file
    : >source/exercises/01_derivatives/velocity_now_old.cpp
    ln -s me@host.1 source/exercises/01_derivatives/.#velocity_now.cpp
    expect 2 course check velocity_now
    is "$(cat err)" "course: $file is not there; ./course reset velocity_now brings it back"
    is "$(state velocity_now)" 'not started'
    expect 0 course reset velocity_now
    cmp -s $file build/exercises/generated/velocity_now_stub.cpp || fail 'the file did not come back'
    is "$(ls -A source/exercises/01_derivatives | grep -c velocity_now)" 3
}

test_odd_files_are_refused_in_one_line() {
    ln -s loop.cpp loop.cpp
    mkfifo fifo
    head -c 1100000 /dev/zero | tr '\0' '\n' >large.cpp
    for odd in "$(printf '%0300d' 0)" loop.cpp fifo large.cpp /dev/zero $file/x; do
        expect 2 timeout 600 sh -c "$(declared) check velocity_now --file '$odd'"
        is "$(cat err | sed 's/ (.*)//')" "course: $odd: cannot be read"
    done
    for empty in --seed --file; do
        expect 2 course check velocity_now $empty ''
        is "$(sed "s/'':.*/''/" err)" "course: $empty ''"
    done
    for command in check watch; do
        expect 2 course $command ''
        says err "'' is no exercise"
        is "$(lines err)" 1
    done
    expect 2 course check velocity_now --seed ' 1'
    says err "course: --seed ' 1': must be"
}

test_no_path_is_obeyed_by_the_terminal() {
    odd=$(printf 'a\033[31m\nb')
    expect 2 course check velocity_now --file "$odd"
    is "$(sed 's/ (.*)//' err)" 'course: a?[31m?b: cannot be read'
    cp $file "$odd"
    expect 1 course check velocity_now --file "$odd"
    says out 'Your file is a?[31m?b.'
}

test_two_commands_at_once_lose_nothing() {
    names=$(basename -s .cpp source/exercises/01_derivatives/*.cpp)
    waiting=
    for name in $names $names; do
        course hint "$name" >/dev/null 2>>err &
        waiting="$waiting $!"
    done
    for one in $waiting; do wait "$one" || fail "a hint ended with status $?"; done
    for name in $names; do says source/.progress/exercises.tsv "$(printf '%s\topen\t2' "$name")"; done
    is "$(ls -A source/.progress | tr '\n' ' ')" 'exercises.tsv lock '
}

test_a_full_standard_output_is_no_success() {
    [ -e /dev/full ] || exit 77
    cp "$mistake" $file
    for words in 'check velocity_now' 'check' 'hint velocity_now' 'watch velocity_now'; do
        got=0
        timeout 600 sh -c "$(declared) $words" >/dev/full 2>err </dev/null || got=$?
        is "$words: $got" "$words: 2"
        says err 'course: standard output: cannot be written'
    done
    expect 0 course hint velocity_now
    is "$(grep -c 'Hint [0-9] of' out)" 1
}

test_an_interrupt_ends_all_and_leaves_nothing() {
    own_build "$works_a_little & "'echo "$! $$" >running; wait'
    signals='TERM HUP'
    [ -z "$default_signals" ] || signals='TERM HUP INT'
    for command in check watch; do
        for signal in $signals; do
            rm -f running
            start_course $command velocity_now
            wait_until [ -s running ]
            kill -"$signal" $running
            got=0
            wait $running || got=$?
            is "$command $signal $got" "$command $signal 130"
            says said 'course: interrupted'
            for process in $(cat running); do
                wait_until is_gone "$process"
            done
            is "$(ls build/exercises | grep check_)" ''
        done
    done
}

test_a_killed_check_leaves_no_compiler() {
    own_build 'echo "$$" >running; '"$works_a_little"
    start_course check velocity_now
    wait_until [ -s running ]
    kill -KILL $running
    wait_until is_gone "$(cat running)"
}

test_watch_notices_what_is_saved_during_a_check() {
    own_build "echo x >>calls; [ -e saved ] || { sleep 0.1; echo >>$file; : >saved; }; exit 1"
    start_course watch velocity_now
    wait_until sh -c '[ "$(grep -c x calls)" = 2 ]'
    kill $running
}

# headers COMMAND: the header compiled beforehand is this fixture's own, and made again by the command.
headers() {
    export CCACHE_DISABLE=1  # which hides the damage
    own_build
    mkdir -p build/exercises/ready
    cp "$real_build"/exercises/ready/exercise.hpp* build/exercises/ready
    header=$(ls build/exercises/ready/exercise.hpp.?ch)
    sed -i "s|$real_build/exercises/ready|$folder/build/exercises/ready|g" build/exercises/commands.json
    printf '#!/bin/sh\n%s\n' "$1" >cmake  # like the build, it makes what is not there
    chmod +x cmake
    mend() { FIXTURE_SOURCE=$folder/source FIXTURE_BUILD=$folder/build FIXTURE_CMAKE=$folder/cmake FIXTURE_CTEST=false "$program" "$@"; }
}

test_a_damaged_header_is_made_again_and_no_answer_blamed() {
    headers "ls '$folder'/build/exercises/ready/exercise.hpp.?ch >/dev/null 2>&1 ||
        cp '$real_build'/exercises/ready/exercise.hpp.?ch '$folder/build/exercises/ready'"
    cp $solved $file
    for size in 0 100 1000000; do
        head -c $size "$real_build/exercises/ready/${header##*/}" >$header
        expect 0 mend check velocity_now
        says out 'right'
    done
    truncate -s 1000000 $header
    : >empty.cpp
    expect 1 mend check velocity_now --file empty.cpp
    says err 'The files for checking velocity_now are damaged; building them again'
    says out 'The file has no function'
    expect 0 mend check velocity_now
    silent_on err damaged
}

test_commands_that_are_damaged_say_how_they_are_made_again() {
    own_build
    for text in '' '{"compile": [' '{}'; do
        echo "$text" >build/exercises/commands.json
        for command in check 'check --sanitize'; do
            # shellcheck disable=SC2086
            expect 3 course $command velocity_now
            is "$(grep -v '^Building' err)" "course: $folder/build/exercises/commands.json is damaged; delete the folder build, and ./course will make it again"
        done
    done
    # CMake makes them again, where it has configured here.
    printf '#!/bin/sh\ncp "%s" "%s"\n' "$real_build/exercises/commands.json" "$folder/build/exercises" >cmake
    chmod +x cmake
    : >build/CMakeCache.txt
    expect 1 env FIXTURE_SOURCE="$folder/source" FIXTURE_BUILD="$folder/build" FIXTURE_CMAKE="$folder/cmake" FIXTURE_CTEST=false \
        "$program" check velocity_now
    says out 'not started'
}

# A zombie is gone, too.
is_gone() { case $(ps -o stat= -p "$1") in '' | Z*) ;; *) return 1 ;; esac; }

# A compiler that only the clock ends, and late: it works too little for its limit.
works_a_little='while :; do seq 300000 >/dev/null; sleep 0.3; done'

# What `timeout sh -c` needs in front of the words for the course.
declared() {
    echo "FIXTURE_SOURCE='$folder/source' FIXTURE_BUILD='$folder/build' FIXTURE_CMAKE=true" \
        "FIXTURE_CTEST=false exec '$program'"
}

program=$4 real_build=$5
begin "$@"
new_fixture
"$function"
