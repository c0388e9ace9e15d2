#pragma once
// A contest: one scene, many methods, and the error and time of each. One run measures the error, others the time.

#include <functional>
#include <string>
#include <vector>

namespace contest {

inline constexpr double duration = 4;  // s, of every scene: with 240 steps it is stepped at 60 Hz
inline constexpr int marks = 30;       // places per run at which it is compared, evenly spaced

using Place = std::vector<double>;  // where everything is: coordinates, or a rotation matrix
using Track = std::vector<Place>;   // the places at the marks, the last one at the end

// What a run needed. A method that chooses its own steps says how many it took.
struct Work {
    long steps = 0;        // taken
    long evaluations = 0;  // of the force
    long solves = 0;       // of a linear system: one per evaluation of the slope by an implicit method
};

// A method in a scene. `steps` is a multiple of `marks`. A method that chooses its own steps (adaptive) takes it as an
// accuracy: its tolerance per step is (marks/steps)² of the scene's size.
struct Entry {
    std::string method, library;
    std::function<Track(long steps)> track;  // the run, with its places
    std::function<void(long steps)> run;     // the same run alone: this one is timed
    std::function<Work(long steps)> work;    // the same run, counted
    bool adaptive = false;
};

struct Scene {
    std::string id, title;       // "spring", "a spring of 1 Hz"
    double size = 1;             // what an error of 100 % is: metres, or radians
    Track reference = {};        // where everything truly is
    double reference_error = 0;  // how well that is known, as a share of `size`; 0: exact
    double patience = 1;         // how many times longer its runs may take than those of other scenes
    std::vector<Entry> entries = {};
};

// One run of one entry. Errors are shares of the scene's size: 0.01 is 1 %.
struct Point {
    std::string scene, method, library;
    long asked = 0;          // steps asked for
    double step = 0;         // s, the mean step taken
    double error_final = 0;  // at the end
    double error_max = 0;    // the largest at any mark
    double seconds = 0;      // the fastest run
    double evaluations = 0, solves = 0;
    bool diverged = false;  // not a number, or wrong by more than a hundred sizes
};

inline volatile double sink;  // a timed run writes its result here, so that the compiler has to compute it

// A run, and its errors.
Point watched(const Scene& scene, const Entry& entry, long steps);

// How hard to try.
struct Effort {
    long most_steps;     // no run is longer
    double longest_run;  // s; a method whose run takes longer is given no shorter steps
    int rounds;          // how often every run is timed, in turns with all others
};
inline constexpr Effort page{30L << 13, 1e-3, 5}, quick{30L << 15, 4e-3, 9}, full{30L << 19, 0.1, 25};

// The same time from mark to mark, and steps that halve: 7.5 Hz, 15, 30, 60, 120, …
std::vector<Point> measure(const Scene& scene, const Effort& effort,
                           const std::function<void(const std::string&)>& progress = {});

// The distance of two places as a share of the scene's size.
double distance(const Scene& scene, const Place& a, const Place& b);

// The fastest run that reaches an accuracy at every mark, where all shorter steps reach it too; interpolated between
// two points of the double logarithmic diagram.
struct Cheapest {
    std::string method, library;  // empty: none reaches it
    double seconds = 0, step = 0;
};
Cheapest cheapest(const std::vector<Point>& points, double accuracy, const std::function<bool(const Point&)>& among);

// In words, with two digits, as measured numbers have no more: 1234 becomes 1200, and 6.21e-7 s becomes 620 ns.
std::string rounded(double value);
std::string time_in_words(double seconds);

}  // namespace contest
