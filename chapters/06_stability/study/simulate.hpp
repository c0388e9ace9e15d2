#pragma once
// A spring, simulated until it is clear what becomes of it.

#include <algorithm>
#include <cmath>
#include <vector>

#include <timestep/multipliers.hpp>
#include <timestep/stability_limit.hpp>

#include "any_method.hpp"

template <class Model>
using OnNumbers = AnyMethod<Model, timestep::State<double>>;

// A method on a spring, and on one with a damper where it takes it; and what theory knows of it.
struct OnSprings {
    const char* name;
    OnNumbers<timestep::Spring<double>> spring;
    OnNumbers<timestep::DampedSpring<double>> damped;
    double (*limit)(double zeta);  // the longest stable ωh
    std::vector<timestep::detail::Complex> (*multipliers)(long double zeta, long double wh);

    template <class Method>
    OnSprings(const Method& m) : name(m.name), spring(m), damped(m) {
        limit = [](double zeta) { return timestep::stability_limit(Method{}, zeta).value; };
        multipliers = [](long double zeta, long double wh) {
            return timestep::detail::multipliers(Method{}, zeta, wh);
        };
    }
};

// A run, piece by piece; of each piece the largest size |x| + |v|/ω.
template <class Model>
class Watched {
public:
    Watched(const OnNumbers<Model>& method, const Model& model, double omega, double h)
        : method_(method), model_(model), omega_(omega), h_(h), before_{0, 0.8, 0.6 * omega} {
        // Two states, where two are needed.
        state_ = method_.from_two ? method_.start(model_, before_, h_) : before_;
    }
    double largest_of(long steps) {
        double largest = 0;
        for (long n = 0; n < steps; ++n) {
            const auto next = method_.step(model_, before_, state_, h_);
            before_ = state_;
            state_ = next;
            const double size = std::abs(state_.x) + std::abs(state_.v) / omega_;
            if (!(size <= largest)) largest = size;  // a NaN is the largest of all
        }
        return largest;
    }

private:
    OnNumbers<Model> method_;
    Model model_;
    double omega_, h_;
    timestep::State<double> before_, state_;
};

/// [outcome]
// Does it grow? The verdict is plain when the size is 1000 times the first or a
// thousandth of it. Else the last quarter of a long run is compared with the
// second: what neither grows nor shrinks is bounded, and that is stable.
template <class Model>
bool grows(const OnNumbers<Model>& method, const Model& model, double omega, double h, long quarter = 32'768) {
    Watched run(method, model, omega, h);
    const double first = run.largest_of(64);
    double second = 0, last = 0;
    for (long n = 64; n < 4 * quarter; n += 256) {
        const double size = run.largest_of(256);
        if (!(size <= 1000 * first)) return true;
        if (size < first / 1000) return false;
        if (n < 2 * quarter && n >= quarter) second = std::max(second, size);
        if (n >= 3 * quarter) last = std::max(last, size);
    }
    return last > 1.001 * second;
}
/// [outcome]
