# A class is graded: the verdicts, what is written, what a submission can see, and interruptions.

. "$(dirname "$0")/class.sh"

# refused NAME TEXT: that is the grade of NAME, and it says so.
refused() {
    is "$1 $(verdict_of "$1")" "$1 refused"
    case $(says_of "$1") in "velocity_now: refused: $2"*) ;; *) fail "$1: $(says_of "$1")" ;; esac
}

# One class with all that is handed in: odd files, answers in odd places and by odd names, and what is no answer.
test_a_class_gets_its_verdicts() {
    needs_isolation
    printf '"]]><&\001 \303\244' | answer 'e<v>&"e'
    mkdir -p class/link class/fifo class/big class/two/a class/two/b class/git/.git class/mac/__MACOSX class/letters \
        class/text class/.git class/many/exercises/01_derivatives
    : >class/.DS_Store
    ln -s "$folder/$solved" class/link/velocity_now.cpp
    mkfifo class/fifo/velocity_now.cpp
    truncate -s 1G class/big/velocity_now.cpp
    cp $solved class/two/a/velocity_now.cpp
    cp $solved class/two/b/velocity_now.cpp
    cp $solved class/git/.git/velocity_now.cpp
    cp $solved class/mac/velocity_now.cc
    : >class/mac/__MACOSX/._velocity_now.cc
    cp $solved class/letters/Velocity_Now.CPP
    cp $solved class/text/velocity_now.txt
    cp $solved class/archive.zip
    cp "$mistake" class/many/velocity_now.cpp
    cp $solved class/many/exercises/01_derivatives/velocity_now.cpp  # the one at its place counts
    expect 1 course grade class --seed 7
    for right in alice mac many; do is "$right $(verdict_of $right)" "$right pass"; done
    is "$(verdict_of bob)$(verdict_of carol)$(verdict_of archive.zip)" wrongnot_startedmissing
    says class.grades/grades.json 'This is the central difference'
    refused link 'velocity_now.cpp is a link, and links are not followed'
    refused fifo 'velocity_now.cpp is no regular file'
    refused big 'velocity_now.cpp is larger than 1 MB'
    refused two '2 files answer it, a/velocity_now.cpp and b/velocity_now.cpp, and exercises/01_derivatives does not'
    refused git ".git/velocity_now.cpp lies where nothing is graded, in '.git': move it"
    refused letters 'Velocity_Now.CPP must be named velocity_now.cpp, in exactly these letters: rename it'
    refused text 'velocity_now.txt does not have the name of a C++ file: rename it to velocity_now.cpp'
    says out 'velocity_now: exercises/01_derivatives/velocity_now.cpp is graded, velocity_now.cpp is left out'
    says out 'Left out: .DS_Store, .git, __MACOSX'
    says out '3 of 14 right, 14 submissions'
    says class.grades/grades.csv '"alice",1,1,pass'
    [ ! -e class.grades/results.json ] || fail 'a class has results.json'
    expect 1 course grade class
    says err ' 6 were graded before'
    command -v python3 >/dev/null || return 0
    python3 - <<'PYTHON' || fail 'junit.xml'
import xml.etree.ElementTree as tree
suite = tree.parse("class.grades/junit.xml").getroot()[0]
assert suite.get("tests") == "14" and suite.get("failures") == "11" and suite.get("errors") == "0"
kinds = {case.get("classname"): [kind.get("type") for kind in case] for case in suite}
assert kinds["alice"] == [] and kinds["bob"] == ["wrong"] and kinds['e<v>&"e'] == ["does_not_compile"], kinds
PYTHON
}

# What cannot be seen cannot be copied, sent or spoilt. The same look from outside sees it all.
test_a_submission_sees_nothing_but_itself() {
    needs_isolation
    mkdir home
    echo secret >home/secret
    export HOME="$folder/home"
    for place in "$source/tests/exercises/01_derivatives/velocity_now/properties.cpp" \
        "$source/solutions/01_derivatives/velocity_now.cpp" "$source/README.md" "$HOME/secret" \
        "$real_build/exercises/hidden/velocity_now" "$real_build/exercises/generated/velocity_now_variants.cpp" \
        "$folder/class/alice/velocity_now.cpp" /etc/passwd /etc/hostname; do
        printf '#if __has_include("%s")\n#error sees %s\n#endif\n' "$place" "$place"
        [ -e "$place" ] || fail "$place is not there: the test tests nothing"
    done >looks.hpp
    {
        cat looks.hpp
        cat "$solved"
    } >class/alice/looks.cpp
    hand_in dave class/alice/looks.cpp
    rm class/alice/looks.cpp
    for place in $(sed -n 's/#error sees //p' looks.hpp); do
        printf 'if (std::fopen("%s", "r") != nullptr) std::puts("sees %s");\n' "$place" "$place"
    done | answer erin
    answer frank <<'CODE'
    for (char** one = environ; *one != nullptr; ++one) std::printf("environment %s\n", *one);
    std::printf("parent %d, files %d\n", getppid() > 9, access("/proc/1", F_OK) == 0);
    for (const char* place : {"/", "/tmp", "/dev", "/usr", "/etc"}) {
        const int folder = open(place, O_TMPFILE | O_WRONLY, 0600);
        if (folder >= 0) std::printf("writes in %s\n", place);
    }
    sockaddr_in away{AF_INET, htons(9), {htonl(0xc0000201)}, {}};  // 192.0.2.1, to which there is a route where there is a network
    if (connect(socket(AF_INET, SOCK_DGRAM, 0), reinterpret_cast<sockaddr*>(&away), sizeof away) == 0) std::puts("has a network");
CODE
    expect 1 course grade class
    for name in alice dave erin frank; do is "$name $(verdict_of $name)" "$name pass"; done
    for name in dave erin frank; do
        case $(says_of $name) in
        *sees* | *writes* | *network* | *HOME* | *STAGE* | *'parent 1'* | *'files 1'*)
            fail "$(says_of $name)" ;;
        esac
    done
    expect 1 course grade class --trust
    is "$(verdict_of dave)" does_not_compile
    case $(says_of erin) in *"sees $HOME/secret"*) ;; *) fail 'a trusted submission sees nothing' ;; esac
}

test_a_killed_grading_goes_on_and_loses_nothing() {
    needs_isolation
    for i in 1 2 3 4 5 6; do hand_in "student$i" "$mistake"; done
    expect 1 course grade class --seed 7 --out whole
    start_course grade class --seed 7
    wait_until sh -c '[ "$(grep -c submission class.grades/journal.jsonl)" -ge 3 ]'
    kill -KILL $running
    wait $running || true
    cp class.grades/journal.jsonl killed
    printf '{"submission": "ali' >>class.grades/journal.jsonl  # and the line it was writing
    expect 1 course grade class
    says err " $(grep -c submission killed) were graded before"
    cmp -s whole/grades.csv class.grades/grades.csv || fail 'other grades than without being killed'
    hand_in bob $solved
    expect 1 course grade class
    says err ' 8 were graded before'
    is "$(verdict_of bob)" pass
    expect 1 course grade class --again --seed 8
    silent_on err 'graded before'
    says out 'seed 8'
}

# The seeds of all grades, each once.
seeds() { sed -n 's/.*"seed": \([0-9]*\).*/\1/p' class.grades/grades.json | sort -u; }

# Who has seen the seed of a grade knows nothing of the next.
test_a_regrade_draws_anew() {
    needs_isolation
    expect 1 course grade class --seed 7
    is "$(seeds)" 7
    expect 1 course grade class --again
    before=$(seeds)
    [ "${#before}" -gt 14 ] || fail "a small seed: $before"
    hand_in bob $solved  # handed in anew, and drawn anew
    expect 1 course grade class
    says err ' 2 were graded before'
    is "$(seeds | grep -c '')" 2
    expect 1 course grade class --seed 7
    silent_on err 'graded before'
}

# The hidden tests of velocity_now are this script.
hidden_tests_are() {
    own_build
    printf '#!/bin/sh\n%s\n' "$1" >hidden
    chmod +x hidden
    sed -i "s|\"velocity_now\": \"[^\"]*/hidden/velocity_now\"|\"velocity_now\": \"$folder/hidden\"|" \
        build/exercises/commands.json
}

# What the kernel does to a program that has worked for longer than it may.
test_tests_that_work_too_long_count_against_the_answer() {
    needs_isolation
    hidden_tests_are 'echo x >>'"$folder"'/runs; kill -XCPU $$'
    expect 1 course grade class/alice --out results
    says out 'velocity_now: too slow'
    says out 'The hidden tests have worked for a minute on what your function returned'
    is "$(lines runs)" 2
    expect 1 course grade class/alice --out results
    says err ' 1 were graded before'
    is "$(lines runs)" 2
}

test_a_course_error_does_not_repeat_for_ever() {
    needs_isolation
    hidden_tests_are 'echo x >>'"$folder"'/runs; exit 77'
    for runs in 1 2 3 3 3; do
        expect 3 course grade class/alice --out results
        says err 'some could not be checked'
        says out 'velocity_now: could not be checked'
        is "$(lines runs)" $runs
    done
    says results/grades.csv '"alice",0,1,course_error'
    expect 3 course grade class/alice --out results --again
    is "$(lines runs)" 4
}

test_an_interrupt_ends_it_and_leaves_nothing() {
    needs_isolation
    own_build
    echo 'raise(SIGSTOP);' | answer dave  # for which the checker waits 20 s
    for signal in TERM KILL; do
        start_course grade class --again
        wait_until sh -c 'ps -e -o args | grep -v grep | grep -q "/[v]elocity_now velocity_now '"$folder"'"'
        kill -$signal $running
        got=0
        wait $running || got=$?
        [ $signal = KILL ] || is "$signal $got" "$signal 130"
        wait_until sh -c '! ps -e -o args | grep -v grep | grep -q "/[v]elocity_now velocity_now '"$folder"'"'
        # What a killed one leaves, the next check sweeps.
        [ $signal = KILL ] || wait_until sh -c '! ls build/exercises/ | grep -q check_'
    done
}

test_two_gradings_at_once() {
    needs_isolation
    echo 'usleep(1000000);' | answer dave
    start_course grade class --out one --seed 7
    wait_until [ -e one/journal.jsonl ]
    kill -STOP $running  # so that it does not come to its end before the other has waited for it
    expect 2 course grade class --out one
    kill -CONT $running
    is "$(cat err)" 'course: one: another grading writes there; --out takes another folder'
    expect 1 course grade class --out two --seed 7
    wait $running || true
    cmp -s one/grades.csv two/grades.csv || fail 'they disturb each other'
    is "$(cut -d, -f 4 one/grades.csv | tr '\n' ' ')" 'velocity_now pass wrong not_started pass '
}

test_without_bubblewrap_it_refuses() {
    mkdir none broken
    expect 3 env PATH="$folder/none" $(words) grade class
    says err 'grade needs bubblewrap (package bubblewrap), which is missing or cannot work here (bwrap: No such file'
    printf '#!/bin/sh\necho "bwrap: No permissions to creating new namespace"\nexit 1\n' >broken/bwrap
    chmod +x broken/bwrap
    expect 3 env PATH="$folder/broken:$PATH" $(words) grade class
    says err 'cannot work here (bwrap: No permissions to creating new namespace)'
    is "$(lines err)" 1
    [ ! -e class.grades/grades.csv ] || fail 'it has graded'
    expect 1 env PATH="$folder/broken:$PATH" $(words) grade class --trust
    is "$(verdict_of alice)$(verdict_of bob)" passwrong
    says out 'without isolation'
}

# For `env`: the course by its words.
words() {
    echo "FIXTURE_SOURCE=$folder/source FIXTURE_BUILD=$folder/build FIXTURE_CMAKE=$(command -v true)" \
        "FIXTURE_CTEST=false $program"
}

grade_class "$@"
