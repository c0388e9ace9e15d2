// What a step takes, of every method of the chapter and of its appendix: one measurement for both pages.

#include <algorithm>
#include <chrono>

#include <timestep/rigid/shapes.hpp>

#include "methods.hpp"

namespace {

volatile double sink;  // a run whose end nobody needs would not be computed

}  // namespace

// The fastest of many runs of ten seconds at 60 Hz; explicit Euler has not burst by then. In turns: a
// slow moment hits all. The rate counts: in shorter steps implicit midpoint takes fewer rounds.
const std::map<std::string, double>& step_times() {
    static const std::map<std::string, double> all = [] {
        using Clock = std::chrono::steady_clock;
        const long steps = 600;
        const Body I = timestep::box(1.0, 1.0, 2.0, 3.0);
        const Spin tumbling = spinning(Vector(1, 10, 0.1));
        std::map<std::string, double> fastest;
        std::map<std::string, Steps> takes;
        for (const auto* list : {&methods(), &others()})
            for (const Method& rule : *list) takes[rule.key] = rule.made(I);
        for (int round = 0; round < 100; ++round)
            for (const auto& [key, take] : takes) {
                const auto begin = Clock::now();
                const Spin end = take(tumbling, 1.0 / 60, steps);
                sink = end.q.w() + end.omega.x();
                const std::chrono::duration<double, std::nano> passed = Clock::now() - begin;
                const auto [at, is_new] = fastest.try_emplace(key, passed.count() / steps);
                if (!is_new) at->second = std::min(at->second, passed.count() / steps);
            }
        return fastest;
    }();
    return all;
}
