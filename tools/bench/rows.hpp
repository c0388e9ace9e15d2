#pragma once
// Rows of a table that are timed in turns.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "timing.hpp"

namespace rows {

struct Row {
    std::string name;
    std::function<void()> pass;  // once over all
    double steps;                // that a pass takes: bodies, times the steps of each
    double nanoseconds = 1e9;    // per step, in the fastest turn
    long passes = 1;             // per turn
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

// Exit status 2 with one line for a program that takes no options, else 0.
inline int refuse_options(int argc, char** argv) {
    if (argc > 1) std::fprintf(stderr, "%s: %s: takes no options\n", argv[0], argv[1]);
    return argc > 1 ? 2 : 0;
}

}  // namespace rows
