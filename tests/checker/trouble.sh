# A learner in trouble: interrupts, two commands at once.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"
. "$here/fixture.sh"

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

# A zombie is gone, too.
is_gone() { case $(ps -o stat= -p "$1") in '' | Z*) ;; *) return 1 ;; esac; }

# A compiler that only the clock ends, and late: it works too little for its limit.
works_a_little='while :; do seq 300000 >/dev/null; sleep 0.3; done'

program=$4 real_build=$5
begin "$@"
new_fixture
"$function"
