// Submissions that crash, or return no numbers. Above each stands its name, and in its
// first line what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- an exception of several lines
// velocity_now crash: first line second line \ at 0x12? end
#include "exercise.hpp"

double velocity_now(double, double, double, double) {
    throw std::runtime_error("first line\n\tsecond line \\ at 0x12\r\nend");
}

// ---- an endless recursion
// velocity_now crash: Segmentation fault
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return velocity_now(x1, x2, x0, h) + x0 * velocity_now(x0, x1, x2, h / 2);
}

// ---- a crash in a thread
// velocity_now crash: Line 8:
#include "exercise.hpp"

#include <thread>

double velocity_now(double x0, double x1, double x2, double h) {
    volatile double* nowhere = nullptr;
    std::thread([nowhere] { *nowhere = 1; }).join();
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- a crash when the program ends
// velocity_now crash: Segmentation fault, after the last call of velocity_now, when the program ended Line 6:
#include "exercise.hpp"

struct Table {
    double* volatile rows = nullptr;
    ~Table() { *rows = 1; }
};
static Table table;

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- not a number
// velocity_now not_finite: Every answer must be a finite number
#include "exercise.hpp"

double velocity_now(double x0, double x1, double, double h) { return std::sqrt(-1 - h) * (x1 - x0); }

// ---- adds to what was never written
// velocity_now wrong: e+303
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    double sum;
    sum += (3 * x2 - 4 * x1 + x0) / (2 * h);
    return sum;
}

// ---- adds to memory that was never written
// velocity_now wrong: e+303
#include "exercise.hpp"

#include <memory>

double velocity_now(double x0, double x1, double x2, double h) {
    const auto sum = std::make_unique_for_overwrite<double[]>(3);
    sum[1] += (3 * x2 - 4 * x1 + x0) / (2 * h);
    return sum[1];
}
