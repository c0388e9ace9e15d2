// One step is a matrix; its eigenvalues say what many steps do.

#include <cstdio>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// The growth a step that a simulation shows. The scene is linear, so the state may be brought back
// to amplitude 1 after each step without changing how it goes on; the first 500 steps let the start
// fade.
template <class Method>
double measured_growth(const Method& method, const Spring<double>& spring, double h) {
    State state{0, 1.0, 0.0};
    double log_growth = 0;
    const int fade = 500, count = 2000;
    for (int i = 0; i < fade + count; ++i) {
        state = method.step(spring, state, h);
        const double size = amplitude(state, spring.omega);
        if (i >= fade) log_growth += std::log(size);
        state = {0, state.x / size, state.v / size};
    }
    return std::exp(log_growth / count);
}

template <class Method, class Formula>
double path(const Method& method, const Formula& formula, lab::Findings& out) {
    const Spring spring(1.0);
    auto& table =
        out.table("eigenvalues_" + lab::id(Method::name) + ".tsv", {"wh", "re1", "im1", "re2", "im2", "radius"});
    auto& points = out.table("growth_" + lab::id(Method::name) + ".tsv", {"wh", "growth"});
    double worst = 0;
    for (int i = 0; i <= 120; ++i) {
        const double wh = i / 40.0;
        const auto matrix = step_matrix(method, spring, wh);
        const auto [a, b] = eigenvalues(matrix);
        table.row({wh, a.real(), a.imag(), b.real(), b.imag(), spectral_radius(matrix)});
        if (i % 8 == 0 && i > 0) {
            const double growth = measured_growth(method, spring, wh);
            points.row({wh, growth});
            worst = std::max(worst, std::fabs(growth / formula(wh) - 1));
        }
    }
    std::printf("  %-20s growth a step, measured against the formula: within %.1e\n", Method::name, worst);
    return worst;
}

}  // namespace

void eigenvalue_paths(const Settings&, lab::Findings& out) {
    out.section("What one step multiplies by");
    const auto grows = [](double wh) { return std::sqrt(1 + wh * wh); };
    const auto shrinks = [](double wh) { return 1 / std::sqrt(1 + wh * wh); };
    // cos θ = 1 − (ωh)²/2: on the unit circle up to ωh = 2, on the real axis beyond.
    const auto turns = [](double wh) {
        const double c = wh * wh / 2 - 1;
        return c <= 1 ? 1.0 : c + std::sqrt(c * c - 1);
    };
    const double e = path(explicit_euler, grows, out);
    const double i = path(implicit_euler, shrinks, out);
    const double s = path(semi_implicit_euler, turns, out);
    // A swing that keeps its size still ends anywhere on its ellipse: the logarithm of the axes'
    // ratio, below 5 here, is spread over 2000 steps. At ωh = 2 growth is linear:
    // log(2500/500)/2000.
    const double spread = 5.0 / 2000;
    out.check("growth_as_predicted", e < spread && i < spread && s < spread,
              "the growth that simulations show is the eigenvalues' magnitude");

    const auto stable = [](double wh) {
        return spectral_radius(step_matrix(semi_implicit_euler, Spring(1.0), wh)) <= 1 + 1e-12;
    };
    const double limit = largest_stable_step(stable, 10.0);
    std::printf("  semi-implicit Euler stops being stable at omega h = %.9f\n", limit);
    out.number("semi_implicit_limit", limit, "", "largest stable omega h of semi-implicit Euler", 7);
    out.check("semi_implicit_limit_is_2", std::fabs(limit - 2) < 1e-6,
              "semi-implicit Euler is stable up to omega h = 2");
}
