#pragma once
// Work and precision: every method on one body and spin, its error and its time.

#include <functional>
#include <string>
#include <vector>

#include "methods.hpp"

namespace contest {

inline constexpr double seconds = 2;  // of the motion
inline constexpr long marks = 30;     // a run is looked at so often: every step at 15 Hz

// A method on one body: its run in so many steps, looked at or timed.
struct Entry {
    std::string name, id;
    bool ours = true;                         // of the chapter's line, not of the appendix
    std::function<double(long steps)> error;  // the largest of the orientation at any mark
    std::function<double(long steps)> run;    // watched by nobody: this one is timed
};

struct Point {
    const Entry* entry;
    double rate = 0;   // steps a second
    double error = 0;  // see apart(); 9 where it is no number
    double time = 0;   // s for a second of the motion, the fastest run
};

// All methods on `inertia` from `start`.
std::vector<Entry> entries(const Body& inertia, const Spin& start);

// Every entry at 15 Hz, 30, 60 and on. Errors first, then times, everybody in turns.
std::vector<Point> measure(const std::vector<Entry>& entries);

}  // namespace contest
