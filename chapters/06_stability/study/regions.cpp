// Where in the plane of z = hλ does a method stay bounded? The formulas, and runs laid over them.

#include <algorithm>
#include <cstdio>
#include <numbers>

#include <Eigen/Dense>

#include <timestep/models/complex_decay.hpp>
#include <timestep/run.hpp>
#include <timestep/stability_function.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double pi = std::numbers::pi, eps = 2.2e-16;
constexpr int fade = 100, count = 300;  // steps

// What a step multiplies by, measured by stepping ẏ = λy. The scene is linear, so
// after each step it may be brought back to size 1 without changing how it goes on.
template <class Method>
double measured_growth(const Method& method, Complex z) {
    const ComplexDecay model(z);
    FirstOrder<Eigen::Vector2d> before{-1, {1, 0}}, state{0, {1, 0}};
    double log_growth = 0;
    for (int i = 0; i < fade + count; ++i) {
        FirstOrder<Eigen::Vector2d> next;
        if constexpr (std::is_same_v<Method, Bdf2>)
            next = method.step(model, before, state, 1);
        else
            next = method.step(model, state, 1);
        const double size = next.y.norm();
        before = {-1, state.y / size};
        state = {0, next.y / size};
        if (i >= fade) log_growth += std::log(size);
    }
    return std::exp(log_growth / count);
}

// By how much may the logarithm of a measured growth be off? A step's terms, up to |z|⁴/24, are
// rounded by ε each, and so is the sum of the logarithms at each addition. Of BDF2's two motions
// the smaller has faded by (r₂/r₁)ᶠᵃᵈᵉ; ten times that is what it can still add to the size at
// either end of the count.
template <class Method>
double bound(const Method& method, Complex z) {
    const double r = std::abs(stability_function(method, z)), size = std::abs(z);
    const double terms = 1 + size + size * size / 2 + std::pow(size, 3) / 6 + std::pow(size, 4) / 24;
    const double rounding = eps * (32 * terms / r + count * std::fabs(std::log(r)));
    if constexpr (!std::is_same_v<Method, Bdf2>) return rounding;
    const double other = std::abs(1.0 / (2.0 + std::sqrt(1.0 + 2.0 * z)));
    return rounding + 2 * 10 * std::pow(other / r, fade) / count;
}

// The region's edge, on rays from a point inside (explicit methods) or outside (those that solve).
template <class Method>
void outline(const Method& method, double center, lab::Findings& out) {
    auto& table = out.table("outline_" + lab::id(method.name) + ".tsv", {"re", "im"});
    const bool inside = std::abs(stability_function(method, center)) <= 1;
    for (int i = 0; i <= 360; ++i) {
        const Complex ray = std::polar(1.0, i * pi / 180);
        double near = 0, far = 8;
        for (int k = 0; k < 50; ++k) {
            const double middle = (near + far) / 2;
            const bool stable = std::abs(stability_function(method, center + middle * ray)) <= 1;
            (stable == inside ? near : far) = middle;
        }
        const Complex z = center + near * ray;
        table.row({z.real(), z.imag()});
    }
}

struct Tally {
    int points = 0, grew = 0;
    double off = 0;    // the largest difference of the logarithms
    double worst = 0;  // and over its bound
    bool agree = true;
};

// A grid of runs, which meets no edge.
template <class Method>
void lay_over(const Method& method, Tally& tally, lab::Findings& out) {
    auto& decayed = out.table("decayed_" + lab::id(method.name) + ".tsv", {"re", "im"});
    auto& grew = out.table("grew_" + lab::id(method.name) + ".tsv", {"re", "im"});
    for (double x = -3.75; x < 4.2; x += 0.5)
        for (double y = -3.25; y < 3.5; y += 0.5) {
            const Complex z(x, y);
            const double predicted = std::abs(stability_function(method, z));
            const double measured = measured_growth(method, z);
            const double off = std::fabs(std::log(measured / predicted));
            tally.off = std::max(tally.off, off);
            tally.worst = std::max(tally.worst, off / bound(method, z));
            tally.agree = tally.agree && (measured > 1) == (predicted > 1);
            ++tally.points;
            if (measured > 1) ++tally.grew;
            (measured > 1 ? grew : decayed).row({x, y});
        }
}

}  // namespace

void regions(const Settings& settings, lab::Findings& out) {
    out.section("The plane of h lambda");
    outline(explicit_euler, -1, out), outline(midpoint, -1, out), outline(runge_kutta_4, -1, out);
    outline(implicit_euler, 1, out), outline(bdf2, 2, out);

    Tally tally;
    for_each_stability_function([&](const auto& method) { lay_over(method, tally, out); });
    std::printf("  %d runs, %d grew, each as |R(z)| says; log of the growth within %.1e\n", tally.points, tally.grew,
                tally.off);
    out.check("regions", tally.agree && tally.worst < 1,
              "every run grows where |R(z)| > 1 and decays elsewhere, by the factor |R(z)|");

    // Scenes: the two decays of a spring, z = ωh (−ζ ± √(ζ² − 1)).
    const double wh = settings.omega * settings.step;
    auto& scenes = out.table("plane_scenes.tsv", {"re", "im", "scene"});
    const auto place = [&](double s, double zeta, const char* name, const char* mirrored) {
        const Complex root = std::sqrt(Complex(zeta * zeta - 1));
        const Complex up = s * (-zeta + root), down = s * (-zeta - root);
        scenes.row({up.real(), up.imag(), std::string(name)});
        scenes.row({down.real(), down.imag(), std::string(mirrored)});
        return up;
    };
    place(0.6, 0, "swing", " ");
    place(1.3, 0.7, " ", " ");  // the figure writes the names of these two
    place(1.1, 1.6, " ", " ");
    const Complex z = place(wh, settings.zeta, "our spring", " ");
    out.number("spring_wh", wh, "", "omega h of our spring");
    out.number("spring_zeta", settings.zeta, "", "damping ratio of our spring");
    const auto factor = [&](const auto& method) { return std::abs(stability_function(method, z)); };
    std::printf("  our spring: a step multiplies by %.3g (explicit Euler), %.3g (midpoint), %.3g (RK4)\n",
                factor(explicit_euler), factor(midpoint), factor(runge_kutta_4));
    out.number("spring_explicit", factor(explicit_euler), "", "|R| of explicit Euler on our spring");
    out.number("spring_midpoint", factor(midpoint), "", "|R| of midpoint on our spring");
    out.number("spring_rk4", factor(runge_kutta_4), "", "|R| of RK4 on our spring");
    out.check("spring_in_the_plane", factor(explicit_euler) > 1 && factor(midpoint) > 1 && factor(runge_kutta_4) < 1,
              "our spring lies inside RK4's region and outside those of explicit Euler and midpoint");
}
