#pragma once
// A method of order three that is stable on stiff decay, to see what stiffness leaves of its order.

#include <cmath>

#include <timestep/methods/implicit_euler.hpp>

// Two stages, each an implicit Euler step of length γh with γ = (3 + √3)/6 (Nørsett 1974,
// Crouzeix 1975). The rates found there are k₁ at t + γh and k₂ at t + (1 − γ)h:
//     y₂ = y₁ + h (k₁ + k₂)/2
struct Sdirk3 {
    static constexpr const char* name = "SDIRK";
    static constexpr int order = 3;

    template <class System>
    timestep::FirstOrder<double> step(const System& f, const timestep::FirstOrder<double>& state, double h) const {
        const double gamma = (3 + std::sqrt(3.0)) / 6;
        const auto rate_at = [&](double t, double from) {
            const timestep::FirstOrder<double> before{t - gamma * h, from};
            return (timestep::implicit_euler.step(f, before, gamma * h).y - from) / (gamma * h);
        };
        const double k1 = rate_at(state.t + gamma * h, state.y);
        const double k2 = rate_at(state.t + (1 - gamma) * h, state.y + (1 - 2 * gamma) * h * k1);
        return {state.t + h, state.y + h * (k1 + k2) / 2};
    }
};

inline constexpr Sdirk3 sdirk_3;
