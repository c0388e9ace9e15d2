// How a contest is measured: errors first, then times, all entries in turns.

#include "contest.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace contest {

namespace {

using Clock = std::chrono::steady_clock;

// Reading the clock takes about 25 ns, which is also its resolution: short runs are timed by the dozen.
constexpr double long_enough = 2e-5;  // s

/// [batch]
// Seconds a run, from one look at the clock to the next.
double seconds_of(const Entry& entry, long steps, long runs) {
    const auto begin = Clock::now();
    for (long i = 0; i < runs; ++i) entry.run(steps);
    const std::chrono::duration<double> passed = Clock::now() - begin;
    return passed.count() / double(runs);
}
/// [batch]

// How many runs the clock can resolve. They also bring data and code into the caches.
long runs_for(const Entry& entry, long steps) {
    long runs = 1;
    while (seconds_of(entry, steps, runs) * double(runs) < long_enough) runs *= 2;
    return runs;
}

// The page quotes every entry at 240 Hz, and ours at 960 Hz where a step is cheap. So each entry gets that far, on a
// slow or busy machine too.
long looked_up(const Scene& scene, const Entry& entry) {
    const double rate = entry.library == "Timestep" && scene.patience == 1 ? 960 : 240;
    return std::lround(rate * duration);
}

// At the roundoff floor shorter steps gain nothing.
bool at_the_floor(const std::vector<Point>& points) {
    if (points.size() < 3) return false;
    const Point* last = &points.back();
    return last[0].error_max < 1e-9 && last[0].error_max > 0.7 * last[-1].error_max &&
           last[-1].error_max > 0.7 * last[-2].error_max;
}

struct Timed {
    const Entry* entry;
    Point point;
    long runs;
};

}  // namespace

double distance(const Scene& scene, const Place& a, const Place& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
    const double distance = std::sqrt(squares) / scene.size;
    return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

// The error is measured in a run of its own: recording the places costs time.
Point watched(const Scene& scene, const Entry& entry, long steps) {
    Point point{scene.id, entry.method, entry.library, steps};
    const Track track = entry.track(steps);
    for (int mark = 0; mark < marks; ++mark) {
        const double error = distance(scene, track[mark], scene.reference[mark]);
        point.error_max = std::max(point.error_max, error);
        point.error_final = error;
    }
    point.diverged = !(point.error_max < 100);
    const Work work = entry.work(steps);
    point.step = duration / double(work.steps);
    point.evaluations = double(work.evaluations);
    point.solves = double(work.solves);
    return point;
}

std::vector<Point> measure(const Scene& scene, const Effort& effort,
                           const std::function<void(const std::string&)>& progress) {
    std::vector<Timed> all;
    for (const Entry& entry : scene.entries) {
        if (progress) progress(entry.method + ", " + entry.library);
        std::vector<Point> points;
        for (long steps = marks; steps <= effort.most_steps; steps *= 2) {
            points.push_back(watched(scene, entry, steps));
            const long runs = runs_for(entry, steps);
            all.push_back({&entry, points.back(), runs});
            double& seconds = all.back().point.seconds;
            seconds = seconds_of(entry, steps, runs);
            // It may have been disturbed.
            for (int again = 0; again < 5 && seconds > scene.patience * effort.longest_run; ++again)
                seconds = std::min(seconds, seconds_of(entry, steps, runs));
            const bool too_long = seconds > scene.patience * effort.longest_run;
            if ((too_long && steps >= looked_up(scene, entry)) || at_the_floor(points)) break;
        }
    }

    /// [turns]
    // In turns: what slows the machine for a moment then slows everybody,
    // and the fastest of many turns is the one that was not disturbed.
    for (int round = 0; round < effort.rounds; ++round) {
        if (progress) progress("timing, round " + std::to_string(round + 1));
        for (Timed& one : all) {
            const auto& [entry, point, runs] = one;
            one.point.seconds = std::min(point.seconds, seconds_of(*entry, point.asked, runs));
        }
    }
    /// [turns]

    std::vector<Point> points;
    for (const Timed& one : all) points.push_back(one.point);
    return points;
}

Cheapest cheapest(const std::vector<Point>& points, double accuracy, const std::function<bool(const Point&)>& among) {
    Cheapest best;
    for (std::size_t first = 0; first < points.size();) {
        std::size_t end = first;  // the points of one entry, steps growing shorter
        while (end < points.size() && points[end].method == points[first].method &&
               points[end].library == points[first].library)
            ++end;
        // From the shortest step back to the longest that is still good enough.
        std::size_t good = end;
        while (good > first && points[good - 1].error_max <= accuracy) --good;
        if (good < end && among(points[first])) {
            const Point& a = points[good];
            double seconds = a.seconds, step = a.step;
            if (good > first && std::isfinite(points[good - 1].error_max) && a.error_max > 0) {
                const Point& b = points[good - 1];  // just not good enough
                const double share = std::log(accuracy / a.error_max) / std::log(b.error_max / a.error_max);
                seconds *= std::pow(b.seconds / a.seconds, share);
                step *= std::pow(b.step / a.step, share);
            }
            if (best.method.empty() || seconds < best.seconds) best = {a.method, a.library, seconds, step};
        }
        first = end;
    }
    return best;
}

std::string rounded(double value) {
    const double unit = value > 0 ? std::pow(10, std::floor(std::log10(value)) - 1) : 1;
    char text[32];
    std::snprintf(text, sizeof text, "%g", std::round(value / unit) * unit);
    return text;
}

std::string time_in_words(double seconds) {
    if (seconds < 1e-6) return rounded(seconds * 1e9) + " ns";
    if (seconds < 1e-3) return rounded(seconds * 1e6) + " µs";
    return rounded(seconds * 1e3) + " ms";
}

}  // namespace contest
