// How work and precision are measured: the error in one run, the time in others.

#include <cmath>
#include <limits>

#include "timing.hpp"
#include "work.hpp"

namespace contest {

namespace {

constexpr double longest = 4e-4;  // s; a method whose run takes longer gets no shorter steps

volatile double sink;  // a run whose end nobody needs would not be computed

// Seconds a run; short runs are timed by the dozen.
double seconds_of(const Entry& entry, long steps, long runs) {
    return lab::seconds_of([&] {
               for (long i = 0; i < runs; ++i) sink = entry.run(steps);
           }) /
           double(runs);
}

Entry entry(const Method& method, const Body& inertia, const Spin& start, bool ours) {
    const Steps take = method.made(inertia);
    Entry e{method.name, method.key, ours, {}, {}};
    e.error = [=](long steps) {
        const Exact exact(inertia, start);
        const double h = seconds / double(steps);
        double worst = 0;
        Spin s = start;
        for (long mark = 1; mark <= marks; ++mark) {
            s = take(s, h, steps / marks);
            const double error = apart(s.q, exact(double(mark * (steps / marks)) * h).q);
            if (!(error <= worst)) worst = std::isnan(error) ? 9 : error;
        }
        return is_finite(s) ? worst : 9;
    };
    e.run = [=](long steps) {
        const Spin s = take(start, seconds / double(steps), steps);
        return s.q.w() + s.omega.x();
    };
    return e;
}

}  // namespace

std::vector<Entry> entries(const Body& inertia, const Spin& start) {
    std::vector<Entry> all;
    for (const Method& m : methods()) all.push_back(entry(m, inertia, start, true));
    for (const Method& m : others()) all.push_back(entry(m, inertia, start, false));
    return all;
}

std::vector<Point> measure(const std::vector<Entry>& entries) {
    std::vector<Point> points;
    std::vector<long> runs;
    for (const Entry& e : entries)
        for (long steps = marks; steps <= 512 * marks; steps *= 2) {
            Point p{&e, double(steps) / seconds, e.error(steps), 0};
            long batch = 1;
            while ((p.time = seconds_of(e, steps, batch)) * double(batch) < 2e-5) batch *= 2;
            if (p.time > longest)  // or was it disturbed?
                p.time = std::min(p.time, seconds_of(e, steps, batch));
            points.push_back(p), runs.push_back(batch);
            // Long enough, but for a slow machine not before a game's rate; or roundoff.
            if ((p.time > longest && p.rate >= 60) || p.error < 1e-12) break;
        }
    for (int round = 0; round < 5; ++round)
        for (std::size_t i = 0; i < points.size(); ++i) {
            Point& p = points[i];
            p.time = std::min(p.time, seconds_of(*p.entry, std::lround(p.rate * seconds), runs[i]));
        }
    for (Point& p : points) p.time /= seconds;
    return points;
}

}  // namespace contest
