# The words of the targets check_NAME, which do without the course program.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

# The words for what a check says in lines KEY VALUE, with this exit status.
words_for() {
    status=$1
    sed 's/ /\t/' >said
    printf '#!/bin/sh\ncat "%s/said"\nprintf "a\\033[2Jb\\n" >"$4"\nexit %d\n' "$folder" "$status" >check
    chmod +x check
    room=$source/tests/exercises/01_derivatives/velocity_now
    echo '{"middle": {"says": "This is the central difference.", "hint": "Look at the last argument."}}' >mistakes.json
    cmake -D NAME=velocity_now -D "FILE=$folder/answer.cpp" -D "ABOUT=$room/about.json" \
        -D "MISTAKES=$folder/mistakes.json" -D "CHECK=$folder/check" -D "WORKER=$folder/answer" -P "$source/tools/cmake/say_verdict.cmake"
}

test_a_mistake_is_told_in_words() {
    expect 1 words_for 1 <<'SAID'
SAID
    says err 'could not be checked'
    printf 'verdict wrong\nproperty it holds\nmisconception middle\narguments (1, 2)\nresult 3\n' >lines
    words_for 1 <lines >out 2>err && fail 'a mistake passes'
    says err 'velocity_now: not yet'
    says err 'This must hold, and does not: it holds'
    says err 'velocity_now(1, 2), which returned 3'
    says err 'This is the central difference'
    says err 'Hint: '
    says err 'a?[2Jb'
}

test_a_pass_needs_its_exit_status() {
    echo 'verdict pass' >lines
    words_for 0 <lines >out 2>err || fail 'a pass fails'
    says err 'velocity_now: right'
    words_for 137 <lines >out 2>err && fail 'a checker that was ended passes'
    says err 'could not be checked'
}

test_a_crash_is_told_with_its_line() {
    printf 'int main() {\n    return *static_cast<volatile int*>(nullptr);\n}\n' >answer.cpp
    c++ -g -no-pie "$folder/answer.cpp" -o answer || exit 77
    address=$(nm answer | sed -n 's/ T main$//p')
    printf 'verdict crash\ndetail Segmentation fault\ntrace 0x1 0x%s\n' "$address" >lines
    words_for 1 <lines >out 2>err && fail 'a crash passes'
    says err 'Segmentation fault, before the first call of velocity_now'
    says err "$folder/answer.cpp:1"
}

begin "$@"
"$function"
