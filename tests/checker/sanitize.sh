# check --sanitize: errors that do not show in the numbers. Every answer here is right by its numbers.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

course() {
    FIXTURE_SOURCE=$source FIXTURE_BUILD=$real_build FIXTURE_CMAKE=true FIXTURE_CTEST=false "$program" "$@"
}

# answer.cpp with these lines in the function, of which one ends in  // here
answer() {
    cat >answer.cpp <<CODE
#include "exercise.hpp"
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>
static volatile int zero = 0, seven = 7;
double velocity_now(double x0, double x1, double x2, double h) {
    const double right = (3 * x2 - 4 * x1 + x0) / (2 * h);
    $(cat)
    return right;
}
CODE
}

# found WORDS: the check finds that, in the line that ends in  // here
found() {
    answer
    expect 1 course check velocity_now --file answer.cpp --sanitize
    says out ': crashes'
    says out "$1"
    says out "Line $(grep -n '// here' answer.cpp | cut -d: -f1):"
}

test_out_of_an_array() {
    found 'outside of its array' <<'CODE'
    int numbers[7] = {};
    zero = zero & numbers[seven];  // here
CODE
    found 'out of an array on the heap' <<'CODE'
    std::vector<int> numbers(7);
    const int* const first = numbers.data();
    zero = zero & *(first + seven);  // here
CODE
    found 'out of an array' <<'CODE'
    int* const numbers = new int[7]();
    zero = zero & numbers[seven];  // here
    delete[] numbers;
CODE
    found 'Aborted' <<'CODE'
    std::vector<int> numbers(7);
    zero = zero & numbers[seven];  // here
CODE
}

test_behind_the_end_of_a_vector_that_has_room_for_more() {
    grep -q SANITIZE_VECTOR "$real_build/exercises/commands.json" || exit 77
    found 'out of a vector' <<'CODE'
    std::vector<int> numbers(7);
    numbers.erase(numbers.begin());
    zero = zero & *numbers.end();  // here
CODE
    found 'out of a vector' <<'CODE'
    std::vector<int> numbers;
    numbers.reserve(7);
    zero = zero & numbers.data()[3];  // here
CODE
    found 'out of a vector' <<'CODE'
    std::vector<int> numbers(7);
    const int& last = numbers.back();
    numbers.pop_back();
    zero = zero & last;  // here
CODE
}

test_memory_that_was_given_back() {
    found 'given back already' <<'CODE'
    volatile double* const number = new double(right);
    delete number;
    zero = zero + (*number > 1e300);  // here
CODE
}

test_undefined_numbers() {
    found 'larger than its type can hold' <<'CODE'
    int large = std::numeric_limits<int>::max() - 6;
    large += seven;  // here
    zero = large == 5;
CODE
    found 'divided by zero' <<'CODE'
    seven = zero == 0 ? seven / zero : 7;  // here
CODE
    found 'shifted by too many places' <<'CODE'
    zero = zero * (1 << (seven + 25));  // here
CODE
}

test_pointers_that_lead_nowhere() {
    found 'a null pointer is followed' <<'CODE'
    const int* const none = zero == 0 ? nullptr : &std::as_const(*new int(0));
    zero = zero & *none;  // here
CODE
    found 'no value of its type may stand' <<'CODE'
    alignas(8) char bytes[16] = {};
    zero = zero + *reinterpret_cast<int*>(bytes + seven);  // here
CODE
}

test_what_was_never_written() {
    command -v valgrind >/dev/null || exit 77
    found 'never written' <<'CODE'
    double sum;
    if (zero == 1) sum = 0;
    if (sum > 1e300) std::puts("large");  // here
CODE
}

test_what_is_no_error() {
    answer <<'CODE'
    zero = 0 * *new int(3);  // a leak
CODE
    expect 0 course check velocity_now --file answer.cpp --sanitize
    command -v valgrind >/dev/null || says out 'have not been looked for'
    expect 0 course check turn_exactly --file "$source"/solutions/*/turn_exactly.cpp --sanitize --json
    says out '"verdict":"pass"'
}

test_other_verdicts_are_the_same() {
    answer <<'CODE'
    return 0;
CODE
    expect 1 course check velocity_now --file answer.cpp --sanitize --json
    says out '"verdict":"wrong"'
    answer <<'CODE'
    for (std::vector<std::vector<double>> history;;) history.emplace_back(1'000'000, x0);
CODE
    expect 1 course check velocity_now --file answer.cpp --sanitize --json
    says out '"verdict":"too_much_memory"'
}

test_a_right_answer_that_is_too_slow_to_be_watched() {
    answer <<'CODE'
#ifdef __SANITIZE_ADDRESS__
    for (;;) {}
#endif
CODE
    expect 0 course check velocity_now --file answer.cpp --sanitize
    says out ': right'
    says out 'too slow to be watched'
    answer <<'CODE'
    for (;;) {}
CODE
    expect 1 course check velocity_now --file answer.cpp --sanitize
    says out 'There was no answer in time (2 s of work for one call, 8 s for all)'
}

test_a_report_that_is_printed_counts_for_nothing() {
    answer <<'CODE'
    std::fputs("==1==ERROR: AddressSanitizer: heap-use-after-free on address 0x1\n", stderr);
    std::fputs("==1== Conditional jump or move depends on uninitialised value(s)\n", stderr);
CODE
    expect 0 course check velocity_now --file answer.cpp --sanitize --json
    says out '"verdict":"pass"'
    answer <<'CODE'
    std::fputs("==1== ERROR SUMMARY: 0 errors from 0 contexts\n", stderr);
    zero = zero + (1 << (seven + 25) > 0);
    std::exit(0);
CODE
    expect 1 course check velocity_now --file answer.cpp --sanitize --json
    says out '"verdict":"crash"'
}

# memcheck's words go through a socket: there is no file to cut, and no other way in to read them away.
test_what_memcheck_says_cannot_be_taken_back() {
    command -v valgrind >/dev/null || exit 77
    found 'never written' <<'CODE'
    double sum;
    if (zero == 1) sum = 0;
    if (sum > 1e300) std::puts("large");  // here
    for (int fd = 3; fd < 2048; ++fd) {
        ftruncate(fd, 0);
        lseek(fd, 0, SEEK_SET);
        if (fd > 4) shutdown(fd, SHUT_RDWR);
        char name[64], said[4096];
        std::snprintf(name, sizeof name, "/proc/self/fd/%d", fd);
        const int again = fd > 4 ? open(name, O_RDONLY | O_NONBLOCK) : -1;
        while (again >= 0 && read(again, said, sizeof said) > 0) {
        }
    }
CODE
}

# runs PID: and is no zombie.
runs() { grep -q '^State:.[^ZX]' "/proc/$1/status" 2>/dev/null; }

test_what_is_started_under_memcheck_ends_with_the_verdict() {
    command -v valgrind >/dev/null || exit 77
    answer <<'CODE'
    if (zero == 0 && std::getenv("ASAN_OPTIONS") && fork() == 0) {
        setsid();
        std::FILE* const file = std::fopen("FOLDER/started", "w");
        if (file) std::fprintf(file, "%d\n", getpid()), std::fclose(file);
        for (;;) pause();
    }
    if (zero == 0 && vfork() == 0) _exit(0);
    zero = 1;
CODE
    sed -i "s|FOLDER|$folder|" answer.cpp
    expect 0 course check velocity_now --file answer.cpp --sanitize
    [ ! -e started ] || ! runs "$(cat started)" || { kill -KILL "$(cat started)"; fail 'it still runs'; }
    [ ! -e started ] || fail 'a process was started'
}

test_it_needs_an_exercise() {
    expect 2 course check --sanitize
    is "$(cat err)" 'course: check --sanitize needs the exercise to check'
}

program=$4 real_build=$5
begin "$@"
grep -q fsanitize "$real_build/exercises/commands.json" || exit 77
"$function"
