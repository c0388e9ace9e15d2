// Submissions that take too long or too much memory, or leave something running. Above each stands its name, and in its
// first line what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- an endless loop
// velocity_now too_slow: in time (2 s of work
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    volatile bool never = false;
    while (!never) {
    }
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- wrong at first and without end later
// velocity_now wrong: a constant velocity comes out exactly
#include "exercise.hpp"

double velocity_now(double, double, double, double) {
    static int calls = 0;
    ++calls;
    for (volatile bool never = false; calls > 40 && !never;) {
    }
    return 0;
}

// ---- listens to no signal
// velocity_now too_slow: wait for what does not come
#include "exercise.hpp"

#include <csignal>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (int signal = 1; signal < 65; ++signal) std::signal(signal, SIG_IGN);
    for (;;) pause();
}

// ---- a thread bomb
// velocity_now crash: Resource temporarily unavailable
#include "exercise.hpp"

#include <thread>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (;;)
        std::thread([] {
            for (;;) pause();
        }).detach();
}

// ---- leaves a grandchild that holds the pipe
// velocity_now left_early: ended with status 0 instead of returning
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    if (fork() == 0 && setsid() > 0 && fork() == 0)
        for (;;) pause();
    _exit(0);
}

// ---- floods what it prints
// velocity_now too_slow: more lines
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    for (;;) std::puts("All tests passed");
}

// ---- too much memory
// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    std::vector<std::vector<double>> history;
    for (std::size_t size = 1'000'000;; size *= 1000) history.emplace_back(size, x0);
    return (x2 - x1) / h;
}

// ---- compiles without end by templates
// velocity_now does_not_compile: The compiler had not come to an end after
#include "exercise.hpp"

template <int depth, long path>
struct Tree {
    static constexpr int size = Tree<depth - 1, 2 * path>::size + Tree<depth - 1, 2 * path + 1>::size;
};
template <long path>
struct Tree<0, path> {
    static constexpr int size = 1;
};

double velocity_now(double, double, double, double) { return Tree<40, 1>::size; }
