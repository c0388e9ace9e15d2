#pragma once
// What the two halves of bench_many share: rows that are timed in turns.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "timing.hpp"

namespace many {

struct Row {
    std::string name;
    std::function<void()> pass;  // once over all
    double steps;                // that a pass takes: bodies, times the steps of each
    double nanoseconds = 1e9;    // a step, in the fastest turn
    long passes = 1;             // a turn
};

inline double time_of(const Row& row) {
    const double seconds = lab::seconds_of([&] {
        for (long i = 0; i < row.passes; ++i) row.pass();
    });
    return 1e9 * seconds / (double(row.passes) * row.steps);
}

// All rows in turns; the fastest turn of each is the least disturbed. A turn takes about 100 µs, or one pass.
inline void measure(std::vector<Row>& rows, int turns) {
    for (Row& row : rows) {
        row.pass();
        const double once = time_of(row) * row.steps;
        row.passes = std::max(1l, long(1e5 / once));
    }
    for (int turn = 0; turn < turns; ++turn)
        for (Row& row : rows) row.nanoseconds = std::min(row.nanoseconds, time_of(row));
}

// "target: at most 0.012, reached".
inline std::string target(double value, double limit, bool at_most = true) {
    char text[80];
    std::snprintf(text, sizeof text, "  target: at %s %g, %s", at_most ? "most" : "least", limit,
                  (at_most ? value <= limit : value >= limit) ? "reached" : "missed");
    return text;
}

int bodies();   // many_bodies.cpp
int springs();  // many_springs.cpp

}  // namespace many
