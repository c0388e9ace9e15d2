// What a step takes, of every method of the chapter and of its appendix: one measurement for both
// pages.

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/tumble.hpp>

#include "methods.hpp"
#include "timing.hpp"

namespace {

volatile double sink;  // a run whose end nobody needs would not be computed

// As around contacts: one half of the step, and the other.
struct CalmTwice : timestep::CalmHalfStep {
    Vector step(const Body& inertia, const Vector& omega, double h) const {
        return CalmHalfStep::step(inertia, CalmHalfStep::step(inertia, omega, h / 2), h / 2);
    }
};

}  // namespace

// The fastest of many runs of ten seconds at 60 Hz; explicit Euler has not burst by then. In turns:
// a slow moment hits all. The rate counts: in shorter steps implicit midpoint takes fewer rounds.
const std::map<std::string, double>& step_times() {
    static const std::map<std::string, double> all = [] {
        const long steps = 600;
        const Body I = timestep::box(1.0, 1.0, 2.0, 3.0);
        const Spin tumbling = spinning(Vector(1, 10, 0.1));
        std::map<std::string, double> fastest;
        std::map<std::string, Steps> takes;
        for (const auto* list : {&methods(), &others()})
            for (const Method& rule : *list) takes[rule.key] = rule.made(I);
        takes["calm_twice"] = [I](Spin s, double h, long n) {
            for (; n > 0; --n) s = timestep::tumble<CalmTwice>.step(I, s, h);
            return s;
        };
        for (int round = 0; round < 100; ++round)
            for (const auto& [key, take] : takes) {
                const double seconds = lab::seconds_of([&, &run = take] {
                    const Spin end = run(tumbling, 1.0 / 60, steps);
                    sink = end.q.w() + end.omega.x();
                });
                double& least = fastest.try_emplace(key, INFINITY).first->second;
                least = std::min(least, 1e9 * seconds / steps);
            }
        return fastest;
    }();
    return all;
}
