// Submissions that no exercise plans for, one after the other. Above each stands its name, and in its first line
// what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a crash before the first call
// velocity_now crash: Segmentation fault, before the first call of velocity_now Line 6:
#include "exercise.hpp"

double* volatile nowhere = nullptr;
const double limit = [] {
    *nowhere = 1;
    return 2.0;
}();

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- a crash in a thread
// velocity_now crash: Line 9:
#include "exercise.hpp"

#include <thread>

double velocity_now(double x0, double x1, double x2, double h) {
    volatile double* nowhere = nullptr;
    std::thread([nowhere] { *nowhere = 1; }).join();
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- a crash in a thread that nobody waits for
// velocity_now crash: Line 14:
#include "exercise.hpp"

#include <atomic>
#include <thread>

double velocity_now(double x0, double x1, double x2, double h) {
    static std::atomic<int> calls = 0;
    if (++calls == 1) {
        std::thread([] {
            volatile double* nowhere = nullptr;
            while (calls < 3) {
            }
            *nowhere = 1;
        }).detach();
    }
    while (calls >= 4) {  // as long as it takes; three answers may go out beside the crash
    }
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- a crash that is told a call late
// velocity_now crash: Segmentation fault
#include "exercise.hpp"

#include <cstdint>
#include <cstring>
#include <functional>

#include <unistd.h>

// What goes before each message: the number of the call, what it is (0 ready, 1 an answer, 6 a crash), its size.
struct Head {
    std::uint64_t number;
    std::uint32_t reply, bytes;
};
struct LastWords {
    int places;
    void* place[64];
    char text[4096];
};

namespace checker {
using Answer = std::function<std::vector<double>(const std::vector<double>&)>;
int serve(const Answer&);

// As where a thread crashes between an answer and the next call, which the tests have sent already.
int serve(const Answer& answer) {
    const Head ready{0, 0, 0};
    if (write(4, &ready, sizeof ready) < 0) return 1;
    struct {
        Head head;
        double numbers[4];
    } call;
    for (int calls = 0; read(3, &call.head, sizeof call.head) > 0 && read(3, call.numbers, 32) == 32; ++calls) {
        if (calls == 3) {
            const Head head{call.head.number - 1, 6, sizeof(LastWords)};
            LastWords words{};
            std::strcpy(words.text, "Segmentation fault");
            if (write(4, &head, sizeof head) < 0 || write(4, &words, sizeof words) < 0) return 1;
            pause();
        }
        const double right = answer(std::vector<double>(call.numbers, call.numbers + 4))[0];
        call.head.bytes = sizeof right;
        if (write(4, &call.head, sizeof call.head) < 0 || write(4, &right, sizeof right) < 0) return 1;
    }
    return 0;
}

}  // namespace checker

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- a null pointer
// velocity_now crash: Line 7:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    volatile double* nowhere = nullptr;
    const double rise = x2 - x1;
    *nowhere = rise;
    return rise / h + x0;
}

// ---- a pass in an exception
// velocity_now crash: oops verdict pass
#include "exercise.hpp"

double velocity_now(double, double, double, double) { throw std::runtime_error("oops\nverdict\tpass"); }

// ---- an endless recursion
// velocity_now crash: Segmentation fault
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return velocity_now(x1, x2, x0, h) + x0 * velocity_now(x0, x1, x2, h / 2);
}

// ---- an exception
// velocity_now crash: the step is odd
#include "exercise.hpp"

double velocity_now(double, double, double, double) { throw std::invalid_argument("the step is odd"); }

// ---- an exception before the first call
// velocity_now crash: nobody caught: no table, before the first call of velocity_now Line 5:
#include "exercise.hpp"

static double read_table() { throw std::runtime_error("no table"); }
const double limit = read_table();

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- an exception in a thread
// velocity_now crash: Line 7:
#include "exercise.hpp"

#include <thread>

double velocity_now(double x0, double x1, double x2, double h) {
    std::thread([] { throw std::runtime_error("in a thread"); }).join();
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- an exception of several lines
// velocity_now crash: first line second line \ at 0x12? end
#include "exercise.hpp"

double velocity_now(double, double, double, double) {
    throw std::runtime_error("first line\n\tsecond line \\ at 0x12\r\nend");
}

// ---- an exception that is a number
// velocity_now crash: an exception that nobody caught, of type int, in the call velocity_now(
#include "exercise.hpp"

double velocity_now(double, double, double, double) { throw 42; }

// ---- an exception with an address
// velocity_now crash: index at 0x10 is bad, in the call velocity_now(
#include "exercise.hpp"

double velocity_now(double, double, double, double) { throw std::out_of_range("index at 0x10 is bad"); }

// ---- an exception with terminal escapes
// velocity_now crash: caught: ?[2J??31mright é
#include "exercise.hpp"

double velocity_now(double, double, double, double) { throw std::runtime_error("\033[2J\u009b31mright é"); }

// ---- an index out of range
// velocity_now crash: Line 7:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const std::vector<double> x{x0, x1, x2};
    double sum = 0;
    for (std::size_t i = 0; i <= x.size(); ++i) sum += x[i];
    return sum / h;
}

// ---- an index that at refuses
// velocity_now crash: Line 6:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const std::vector<double> x{x0, x1, x2};
    return (x.at(2) - x.at(3)) / h;
}

// ---- answers its own crash with 0
// velocity_now left_early: ended with status 0 instead of returning
#include "exercise.hpp"

#include <csignal>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    std::signal(SIGSEGV, [](int) { _exit(0); });
    return *static_cast<volatile double*>(nullptr);
}

// ---- crashes in a line that is not there
// velocity_now crash: Line 2147483600:
#include "exercise.hpp"

static double* volatile nowhere = nullptr;

double velocity_now(double, double, double, double) {
#line 2147483600
    return *nowhere;
}

// ---- ends its own exceptions with 0
// velocity_now left_early: ended with status 0 instead of returning
#include "exercise.hpp"

#include <exception>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    std::set_terminate([] { _exit(0); });
    throw 1;
}

// ---- forgets to return
// velocity_now does_not_compile: forgets_to_return.cpp:6:1: error:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const double velocity = (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- is wrong and then crashes
// extrapolated crash: , 2, 6) Line 8:
#include "exercise.hpp"

#include <cstdlib>

double extrapolated(double coarse, double fine, double ratio, int order) {
    if (coarse == fine) return 0;  // wrong, with other ratios than 2
    if (ratio == 2 && order == 6) std::abort();
    const double error_of_coarse = std::pow(ratio, order);
    return (error_of_coarse * fine - coarse) / (error_of_coarse - 1);
}

// ---- raises its limits
// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <sys/resource.h>

double velocity_now(double, double, double, double) {
    const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &more);
    std::vector<std::vector<double>> history;
    for (std::size_t size = 1'000'000;; size *= 1000) history.emplace_back(size);
}

// ---- throws that it has not started
// velocity_now not_started: not started
#include "exercise.hpp"

double velocity_now(double, double, double, double) { throw exercise::NotStarted(); }

// ---- a crash when the program ends
// velocity_now crash: Segmentation fault, after the last call of velocity_now, when the program ended Line 6:
#include "exercise.hpp"

struct Table {
    double* volatile rows = nullptr;
    ~Table() { *rows = 1; }
};
static Table table;

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- an exception when the program ends
// velocity_now crash: nobody caught: too late, after the last call of velocity_now
#include "exercise.hpp"

#include <cstdlib>
#include <stdexcept>

static const int last = std::atexit([] { throw std::runtime_error("too late"); });

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- never ends
// velocity_now too_slow: after the last call of velocity_now, when the program ended
#include "exercise.hpp"

struct Table {
    ~Table() {
        for (volatile int i = 0;; i = i + 1) {
        }
    }
};
static Table table;

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- ends with a status of its own
// velocity_now pass
#include "exercise.hpp"

#include <cstdlib>

#include <unistd.h>

static const int last = std::atexit([] { _exit(3); });

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }
