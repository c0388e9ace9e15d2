# What no submission in a file can hold: it needs to know where things are, is no text, or runs beside others.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

course() { FIXTURE_SOURCE=$source FIXTURE_BUILD=$real_build FIXTURE_CMAKE=true FIXTURE_CTEST=false "$program" "$@"; }
solution() { cat "$source/solutions/01_derivatives/velocity_now.cpp"; }

# refused WORDS: answer.cpp does not compile, and the words say why.
refused() {
    expect 1 course check velocity_now --file answer.cpp
    says out ': does not compile'
    says out "$1"
}

test_a_file_of_another_system_is_read() {
    { printf '\357\273\277'; solution | sed 's/$/\r/'; } >answer.cpp
    expect 0 course check velocity_now --file answer.cpp
    solution | iconv -t UTF-16 >answer.cpp
    refused 'Save it as UTF-8'
}

test_a_link_to_the_solution_is_not_ones_own() {
    ln -s "$source/solutions/01_derivatives/velocity_now.cpp" 'a$b $$(c) #d.hpp'
    echo '#include "a$b $$(c) #d.hpp"' >answer.cpp
    refused 'The file includes solutions/01_derivatives/velocity_now.cpp.'
}

# Ten digits do not tell it from what is right: then more are printed.
test_a_result_that_is_shown_is_wrong_as_it_is_printed() {
    solution | sed 's|/ 2;|/ 2 + 3e-11 * newer;|' >answer.cpp
    expect 1 course check velocity_now --file answer.cpp --seed 1
    shown=$(tr '\n' ' ' <out | tr -s ' ' | sed 's/.* returned \([^ ]*\)[; ].*/\1/')
    [ ${#shown} -gt 11 ] || fail "$shown"
}

# stopped: answer.cpp stops itself in its first call. Leaves the worker's number and the checker's in `pids`.
stopped() {
    cat >answer.cpp <<CODE
#include "exercise.hpp"
#include <csignal>
#include <cstdio>
#include <unistd.h>
double velocity_now(double x0, double x1, double x2, double h) {
    static bool first = true;
    if (first) std::printf("$folder %d %d\n", getpid(), getppid()), raise(SIGSTOP);
    first = false;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
CODE
    course check velocity_now --file answer.cpp >out 2>err &
    asked=$!
    while kill -0 $asked 2>/dev/null; do
        ! grep -hs "^$folder .* " "$real_build"/exercises/check_*/printed.txt >pids || break
        sleep 0.02
    done
    read -r _ worker checker <pids && [ -n "$checker" ] || fail 'there is no worker'
}

test_a_worker_ends_with_its_checker() {
    stopped
    kill -KILL "$checker"
    wait $asked && status=0 || status=$?
    is "$status" 1
    says out 'ended the checker'
    for _ in $(seq 6000); do
        # In a container ended processes may stay to be counted: those do not run.
        grep -q '^State:.[^ZX]' "/proc/$worker/status" 2>/dev/null || return 0
        sleep 0.1
    done
    fail "the worker still runs"
}

# Held up by others it is not too slow: the checker's two seconds are seconds of work.
test_who_gets_no_processor_is_not_too_slow() {
    stopped
    sleep 3
    kill -CONT "$worker" || fail 'the worker has been ended'
    wait $asked || fail 'it does not pass'
    says out ': right'
}

# sanitized VERDICT: with these lines in the function, right by its numbers, check --sanitize says so.
sanitized() {
    grep -q fsanitize "$real_build/exercises/commands.json" || exit 77
    cat >answer.cpp <<CODE
#include "exercise.hpp"
static volatile int zero = 0, seven = 7;
double velocity_now(double x0, double x1, double x2, double h) {
    $(cat)
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
CODE
    course check velocity_now --file answer.cpp --sanitize >out 2>err || true
    says out "$1"
}

test_sanitize_shows_the_report_and_the_line() {
    sanitized ': crashes' <<'CODE'
    std::vector<int> numbers(7);
    zero = zero & *(numbers.data() + seven);  // here
CODE
    says out "The sanitizer, or your code, printed:"
    says out heap-buffer-overflow
    says out "Line $(grep -n '// here' answer.cpp | cut -d: -f1):"
    sanitized ': crashes' <<'CODE'
    zero = zero * (1 << (seven + 25));  // here
CODE
    says out 'runtime error: shift exponent 32'
    says out "Line $(grep -n '// here' answer.cpp | cut -d: -f1):"
}

test_sanitize_leaves_other_verdicts_as_they_are() {
    echo 'zero = 0 * *new int(3);  // a leak' | sanitized ': right'
    echo 'return 0;' | sanitized ': not yet'
    echo 'for (std::vector<std::vector<double>> history;;) history.emplace_back(1000000, x0);' | sanitized 'too much memory'
}

program=$4 real_build=$5
begin "$@"
"$function"
