#pragma once
// Implicit Euler with a step that fits itself to the motion.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <timestep/methods/implicit_euler.hpp>

struct Account {
    long steps = 0, refused = 0;
    double shortest = 1e300, longest = 0;  // s
};

/// [adaptive]
// Each step is taken twice, whole and in two halves. The whole one errs twice as
// much, so their difference d is the error of the halves, of size h². Each
// unknown's is divided by what is allowed, relative·|y| + absolute. If the sum is
// more than one, the step is refused. The next one is as long as that fits. Kept
// is the halves minus d: chapter 1's Richardson extrapolation, of order two.
template <class System, class Y, class Observe>
timestep::FirstOrder<Y> run_adaptive(const System& f, timestep::FirstOrder<Y> state, double end, double relative,
                                     double absolute, Account& account, const Observe& observe) {
    double h = 1e-6;
    while (state.t < end) {
        h = std::min(h, end - state.t);
        if (!(state.t + h > state.t)) throw std::runtime_error("no step fits");
        const auto whole = timestep::implicit_euler.step(f, state, h);
        const auto middle = timestep::implicit_euler.step(f, state, h / 2);
        const auto halves = timestep::implicit_euler.step(f, middle, h / 2);
        const Y d = whole.y - halves.y;
        const Y wanted = (relative * halves.y.array().abs() + absolute).matrix();
        const double error = d.cwiseQuotient(wanted).cwiseAbs().sum();
        if (error <= 1) {
            account.shortest = std::min(account.shortest, h);
            account.longest = std::max(account.longest, h);
            ++account.steps;
            const bool last = !(h < end - state.t);
            state = {last ? end : state.t + h, halves.y - d};
            observe(state);
        } else {
            ++account.refused;
        }
        const double fits = 0.9 / std::sqrt(error);  // may be a NaN
        h *= fits > 0.2 ? std::min(fits, 5.0) : 0.2;
    }
    return state;
}
/// [adaptive]
