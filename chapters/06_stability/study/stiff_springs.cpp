// The very stiff spring and the very hard damper, at 60 steps a second, by every method.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "sections.hpp"
#include "simulate.hpp"

using namespace timestep;

namespace {

constexpr double h = 1.0 / 60;
constexpr long ten_seconds = 600;

// What has become of a spring after ten seconds: the step at which it was a million times too
// large, or what is left of it.
template <class Model>
std::string outcome(const OnNumbers<Model>& method, const Model& model, double omega) {
    long n = 0, blown = 0;
    double left = 0;
    run(method, model, State<double>{0, 1, 0}, h, ten_seconds, [&](const State<double>& s) {
        left = std::hypot(s.x, s.v / omega);
        if (blown == 0 && !(left < 1e6)) blown = n;
        ++n;
    });
    if (blown > 0) return "gone at step " + std::to_string(blown);
    return left < 1e-6 ? "nothing left" : times(left);
}

enum Fate { swings, dies, rings, blows_up };

// What a kicked spring does in ten seconds, in one word. It rings when its velocity changes sign in
// each of the last hundred steps and is more than a thousandth of the kick.
template <class Model>
Fate fate(const OnNumbers<Model>& method, const Model& model, double omega) {
    double left = 0, before = 0;
    long turns = 0;
    run(method, model, State<double>{0, 0, omega}, h, ten_seconds, [&](const State<double>& s) {
        left = std::hypot(s.x, s.v / omega);
        turns = s.v * before < 0 && std::fabs(s.v) > 1e-3 * omega ? turns + 1 : 0;
        before = s.v;
    });
    if (!(left < 10)) return blows_up;
    if (turns >= 100) return rings;
    return left < 0.1 ? dies : swings;
}

// The picture: a mark for each method and each spring, and for each method and each damper.
void fates(lab::Findings& out) {
    auto& springs = out.table("spring_fates.tsv", {"omega", "row", "fate"});
    auto& dampers = out.table("damper_fates.tsv", {"zeta", "row", "fate"});
    double row = 0;
    bool explicit_gone = true, implicit_stay = true, ring = true;
    const auto of_springs = [&](const OnSprings& method) {
        const std::string name = method.name;
        const bool implicit = name.starts_with("implicit") || name == "BDF2";
        ++row;
        for (int i = 0; i <= 24; ++i) {
            const double omega = std::pow(10, i / 3.0);
            Fate f = fate(method.spring, Spring<double>(omega), omega);
            if (f == rings) f = swings;  // no damper: so it should
            springs.row({omega, row, double(f)});
            if (omega > 200) (implicit ? implicit_stay : explicit_gone) &= (f == blows_up) != implicit;
        }
    };
    const auto of_both = [&](const OnSprings& method) {
        of_springs(method);
        const bool should_ring = std::string(method.name) == "implicit midpoint";
        for (int i = 0; i <= 24; ++i) {
            const double zeta = std::pow(10, i / 3.0 - 2);
            const Fate f = fate(method.damped, DampedSpring<double>(10, zeta), 10);
            dampers.row({zeta, row, double(f)});
            if (zeta > 3e3) ring &= (f == rings) == should_ring;
        }
    };
    of_both(bdf2), of_both(implicit_euler), of_both(implicit_midpoint);
    of_springs(velocity_verlet), of_springs(verlet);  // a damper needs the velocity
    of_both(semi_implicit_euler_new_damping), of_both(semi_implicit_euler);
    of_both(runge_kutta_4), of_both(heun), of_both(midpoint), of_both(constant_acceleration), of_both(explicit_euler);
    out.check("fates_of_springs", explicit_gone && implicit_stay,
              "above 200 rad/s every method but the three implicit ones blows up, and these never do");
    out.check("only_midpoint_rings", ring, "of all methods only implicit midpoint rings with a hard damper");

    // Its velocity after a kick, until a tenth of it is left.
    const DampedSpring<double> damper(10, 1e6);
    State<double> state{0, 0, 1};
    long n = 0;
    for (; std::fabs(state.v) > 0.1; ++n) state = implicit_midpoint.step(damper, state, h);
    // Each step multiplies it by (1 − c/2)/(1 + c/2) ≈ −(1 − 4/c), c = 2ζωh.
    const double predicted = std::log(10) * 2 * 1e6 * 10 * h / 4;
    std::printf("  kicked against zeta = 1e6, implicit midpoint rings: a tenth is left after %ld steps\n", n);
    out.number("ring_minutes", double(n) * h / 60, "min", "until the ringing is down to a tenth", 2);
    out.check("ring_lasts", std::fabs(double(n) / predicted - 1) < 1e-3,
              "the ringing of implicit midpoint takes log(10) c/4 steps to fall to a tenth");
}

}  // namespace

void stiff_springs(const Settings&, lab::Findings& out) {
    out.section("Stiff springs and hard dampers at 60 Hz");
    const std::vector<double> omegas{1, 10, 100, 1e3, 1e4, 1e8};
    auto& springs = out.table("stiff_springs.tsv", {"method", "ω = 1", "10", "100", "1000", "10⁴", "10⁸ rad/s"});
    std::printf("  %-34s %s\n", "after ten seconds, a spring of", "1, 10, 100, 1e3, 1e4, 1e8 rad/s:");
    bool as_predicted = true;
    const auto spring_row = [&](const OnSprings& method) {
        std::vector<lab::Cell> cells{method.name};
        std::printf("  %-34s", method.name);
        for (const double omega : omegas) {
            const std::string what = outcome(method.spring, Spring<double>(omega), omega);
            cells.push_back(what);
            std::printf(" %s,", what.c_str());
            // Gone is what grows more than a million-fold in ten seconds. (Close to it, the shape
            // of the swing decides.)
            const double s = omega * h;
            double largest = 0;
            for (const auto& each : method.multipliers(0, s)) largest = std::max(largest, double(std::abs(each)));
            const double grown = ten_seconds * std::log10(largest);
            const bool gone = what.starts_with("gone");
            if (grown > 7 || grown < 5) as_predicted = as_predicted && gone == (grown > 6);
        }
        std::printf("\n");
        springs.row(cells);
    };
    for_each_method(spring_row);
    for_each_verlet_method(spring_row);
    out.check("stiff_springs_as_predicted", as_predicted,
              "a spring is gone where the eigenvalues say so, and nowhere else");

    // The damper: ω = 10 rad/s, ζ from 1 to a million.
    auto& dampers = out.table("hard_dampers.tsv", {"method", "ζ = 1", "10", "100", "10⁴", "10⁶"});
    bool holds = true;
    const auto damper_row = [&](const OnSprings& method) {
        std::vector<lab::Cell> cells{method.name};
        for (const double zeta : {1.0, 10.0, 100.0, 1e4, 1e6}) {
            const std::string what = outcome(method.damped, DampedSpring<double>(10, zeta), 10);
            cells.push_back(what);
            holds = holds && what.starts_with("gone") == (10 * h > method.limit(zeta));
        }
        dampers.row(cells);
    };
    for_each_method(damper_row);
    damper_row(semi_implicit_euler_new_damping);
    damper_row(constant_acceleration);
    out.check("hard_dampers_as_predicted", holds,
              "a damper is gone where the longest stable step is exceeded, and nowhere else");
    fates(out);
}
