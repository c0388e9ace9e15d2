// Submissions that no exercise plans for, one after the other. Above each stands its name, and in its first line
// what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a quaternion is shown by the names of its parts
// turn_exactly wrong: Quaterniond(0.5, 0.25, 0.125, 1); right is
#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond&, const Vector3d&, double) { return Quaterniond(0.5, 0.25, 0.125, 1); }

// ---- floods the error output
// velocity_now too_slow: more lines
#include "exercise.hpp"

#include <iostream>

double velocity_now(double, double, double, double) {
    for (;;) {
        std::cerr << "All tests passed\n";
        std::cerr.clear();
    }
}

// ---- floods what it prints
// velocity_now too_slow: more lines
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    for (;;) std::puts("All tests passed");
}

// ---- prints and crashes
// velocity_now crash: Your code printed: before the crash
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double x0, double x1, double x2, double h) {
    std::printf("before the crash\n");
    volatile double* nowhere = nullptr;
    *nowhere = x2 - x1;
    return x0 / h;
}

// ---- prints and loops
// velocity_now too_slow: Your code printed: step
#include "exercise.hpp"

#include <iostream>

double velocity_now(double x0, double x1, double x2, double h) {
    std::cout << "step " << h;
    for (volatile bool never = false; !never;) {
    }
    return x0 + x1 + x2;
}

// ---- prints one line without end
// velocity_now wrong: <<<<<<…
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    for (int i = 0; i < 2'000; ++i) std::putchar('<');
    return 0;
}

// ---- prints terminal escapes
// velocity_now wrong: printed: ?[2J?[H?]0;right?
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    static bool first = true;
    if (first) std::printf("\033[2J\033[H\033]0;right\a\n");
    first = false;
    return 0;
}

// ---- prints two lines
// velocity_now pass: Your code printed: one two
#include "exercise.hpp"

#include <iostream>

double velocity_now(double x0, double x1, double x2, double h) {
    static bool first = true;
    if (first) std::ios::sync_with_stdio(false);
    if (first) std::cout << "one\ntwo";
    first = false;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- prints what it does
// velocity_now pass: Your code printed:
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double x0, double x1, double x2, double h) {
    std::printf("older %g, newer %g\n", (x1 - x0) / h, (x2 - x1) / h);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- prints what turns the line round
// velocity_now wrong: ??31m ??? ??? ω é
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    std::puts(
        "\xff\x9b"
        "31m \xe2\x80\xae \xe2\x81\xa6 ω é");
    return 0;
}

// ---- says that all tests passed
// velocity_now left_early: All tests passed
#include "exercise.hpp"

#include <cstdio>
#include <cstdlib>

double velocity_now(double, double, double, double) {
    std::puts("All tests passed (1000 assertions in 10 test cases)\nverdict\tpass");
    std::exit(0);
}

// ---- types into the terminal
// velocity_now wrong: no terminal: No such device or address
#include "exercise.hpp"

#include <cstdio>

#include <fcntl.h>

double velocity_now(double, double, double, double) {
    if (open("/dev/tty", O_RDONLY) < 0) std::perror("no terminal");
    return 0;
}
