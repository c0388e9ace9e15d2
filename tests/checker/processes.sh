# What the learner's code leaves running: nothing.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

course() {
    FIXTURE_SOURCE=$source FIXTURE_BUILD=$real_build FIXTURE_CMAKE=true FIXTURE_CTEST=false "$program" "$@"
}

# answer.cpp with these lines in the function; `say_pids` prints its own and its parent's.
answer() {
    cat >answer.cpp <<CODE
#include "exercise.hpp"
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <unistd.h>
static void say_pids() { std::printf("$folder %d %d\n", getpid(), getppid()); }
double velocity_now(double x0, double x1, double x2, double h) {
    static bool first = true;
    $(cat)
    first = false;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
CODE
}

# In a container ended processes may stay to be counted: those do not run.
runs() { grep -q '^State:.[^ZX]' "/proc/$1/status" 2>/dev/null; }

ends() {
    for _ in $(seq 6000); do
        runs "$1" || return 0
        sleep 0.1
    done
    fail "process $1 still runs"
}

test_a_worker_ends_with_its_checker() {
    # Stopped it neither works nor sleeps: so the checker waits for it, a minute, and not two seconds.
    echo 'say_pids(); raise(SIGSTOP);' | answer
    course check velocity_now --file answer.cpp >out 2>err &
    asked=$!
    while kill -0 $asked; do
        ! grep -hs "^$folder .* " "$real_build"/exercises/check_*/printed.txt >pids || break
        sleep 0.02
    done 2>/dev/null
    read -r _ worker checker <pids && [ -n "$checker" ] || fail 'there is no worker'
    kill -KILL "$checker"
    ends "$worker"
    wait $asked && status=0 || status=$?
    is "$status" 1
    says out 'ended the checker'
}

# Held up by others it is not too slow: the checker's two seconds are seconds of work.
test_who_gets_no_processor_is_not_too_slow() {
    echo 'if (first) say_pids(), raise(SIGSTOP);' | answer
    course check velocity_now --file answer.cpp >out 2>err &
    asked=$!
    while kill -0 $asked; do
        ! grep -hs "^$folder .* " "$real_build"/exercises/check_*/printed.txt >pids || break
        sleep 0.02
    done 2>/dev/null
    read -r _ worker _ <pids && [ -n "$worker" ] || fail 'there is no worker'
    sleep 3
    kill -CONT "$worker" || fail 'the worker has been ended'
    wait $asked || fail 'it does not pass'
    says out ': right'
}

# Neither on the checker's command line nor on that of who has begun it.
test_the_seed_is_on_no_command_line() {
    answer <<'CODE'
    for (int pid = getppid(), next = 0; first && pid > 1; pid = next, next = 0) {
        char name[64], words[4096] = "";
        std::snprintf(name, sizeof name, "/proc/%d/cmdline", pid);
        std::FILE* file = std::fopen(name, "r");
        const size_t size = file ? std::fread(words, 1, sizeof words, file) : 0;
        for (size_t i = 0; i < size; ++i) std::putchar(words[i] == 0 ? ' ' : words[i]);
        std::puts("");
        std::snprintf(name, sizeof name, "/proc/%d/stat", pid);
        file = std::fopen(name, "r");
        if (!file || std::fscanf(file, "%*d %*s %*c %d", &next) != 1) break;
    }
CODE
    for seed in '--seed 123454321' --seed=123454321; do
        # shellcheck disable=SC2086  # a word or two
        expect 0 course check velocity_now --file answer.cpp $seed
        says out 'check velocity_now'
        silent_on out 123454321
    done
}

# Seeds below a million can all be tried within a call.
test_seeds_are_of_64_bits() {
    for _ in 1 2 3 4; do
        expect 1 course check velocity_now --file "$real_build/exercises/generated/velocity_now_stub.cpp" --json
        sed 's/.*"seed":\([0-9]*\).*/\1/' out
    done >seeds
    is "$(sort -u seeds | grep -c '')" 4
    [ "$(sort -n seeds | tail -n 1 | wc -c)" -gt 17 ] || fail "all are small: $(cat seeds)"
}

test_threads_may_be_started_and_processes_not() {
    answer <<'CODE'
    if (first) std::thread([] { std::puts("a thread"); }).join();
    if (first) std::printf("fork: %d\n", fork());
    if (first) std::printf("vfork: %d\n", vfork());
    if (first && std::system("echo a process") != 0) std::puts("system: none");
CODE
    expect 0 course check velocity_now --file answer.cpp
    says out 'a thread'
    says out 'fork: -1'
    says out 'vfork: -1'
    says out 'system: none'
    silent_on out 'a process'
}

program=$4 real_build=$5
begin "$@"
"$function"
