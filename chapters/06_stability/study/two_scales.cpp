// One system, two time scales: what is slow is wanted, and what is fast decides the step.

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include <Eigen/Dense>

#include <timestep/models/coupled_springs.hpp>
#include <timestep/stability_limit.hpp>

#include "any_method.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

using Two = Eigen::Vector2d;
using Row = CoupledSprings<double, 2>;

// Two masses of 1 kg, each tied to its wall by 1 N/m and to the other by a rod that gives a little:
// in step they swing at 1 rad/s, against each other at 1e4.
Row two_scales_row() {
    const double rod = (1e8 - 1) / 2;
    return {Two(1, 1), Eigen::Vector3d(1, rod, 1)};
}

struct Ended {
    double slow_error, fast;  // of the swing in step, and what is left of that against each other
};

Ended after_ten_seconds(const AnyMethod<Row, State<Two>>& method, const Row& row, double h) {
    const State<Two> start{0, {1 + 1e-3, 1 - 1e-3}, {0, 0}};
    const State<Two> end = run(method, row, start, h, std::lround(10 / h));
    const double slow = (end.x[0] + end.x[1]) / 2, slow_v = (end.v[0] + end.v[1]) / 2;
    const double fast = (end.x[0] - end.x[1]) / 2, fast_v = (end.v[0] - end.v[1]) / 2;
    return {std::hypot(slow - std::cos(10.0), slow_v + std::sin(10.0)), std::hypot(fast, fast_v / 1e4)};
}

}  // namespace

void two_scales(const Settings&, lab::Findings& out) {
    out.section("Two time scales in one system");
    const auto row = two_scales_row();
    auto& table = out.table("two_scales.tsv", {"method", "steps a second", "error of the slow oscillation, m",
                                               "left of the fast oscillation"});
    std::printf("  %-34s %8s %12s %12s\n", "ten seconds", "steps/s", "slow error", "fast left");
    std::map<std::string, Ended> ended;
    const auto words = [](double x) {
        char text[24];
        std::snprintf(text, sizeof text, x < 1e6 ? "%.1e" : "blown up", x);
        return std::string(text);
    };
    // At 60 Hz, and where a method does not stand that, with as few steps as the fast swing allows.
    const auto at = [&](const AnyMethod<Row, State<Two>>& method, double rate) {
        const Ended e = after_ten_seconds(method, row, 1 / rate);
        std::printf("  %-34s %8.0f %12s %12s\n", method.name, rate, words(e.slow_error).c_str(), words(e.fast).c_str());
        ended[method.name + std::string(rate > 60 ? ", enough" : "")] = e;
        return e;
    };
    const auto every = [&](const AnyMethod<Row, State<Two>>& method, double limit) {
        Ended e = at(method, 60);
        double rate = 60;
        if (limit > 0 && std::isfinite(limit)) e = at(method, rate = std::ceil(1.0001e4 / limit));
        char left[24];
        std::snprintf(left, sizeof left, "%.0f %%", 100 * e.fast / 1e-3);
        if (limit > 0)
            table.row({method.name, std::to_string(std::lround(rate)), words(e.slow_error), left});
        else
            table.row({method.name, "none is enough", "–", "–"});
    };
    for_all_methods([&](const auto& method) { every(method, stability_limit(method, 0).value); });
    const Ended euler = ended["implicit Euler"], middle = ended["implicit midpoint"], bdf = ended["BDF2"];
    int gone = 0, enough = 0;
    for (const auto& [name, e] : ended) {
        gone += !(e.fast < 1e6);
        enough += name.find(", enough") != std::string::npos && e.slow_error < 0.1 && e.fast < 0.1;
    }
    // Explicit Euler, midpoint, Heun and constant acceleration have no step that is short enough.
    out.check("two_scales_explicit", gone == 10 && enough == 6,
              "of the ten explicit methods none stands 60 Hz; with as many steps as theory asks "
              "for six do");
    out.check("two_scales_implicit", euler.fast < 1e-15 && euler.slow_error > 0.05,
              "implicit Euler kills the fast oscillation and damps the slow one");
    out.check("two_scales_midpoint", std::abs(middle.fast / 1e-3 - 1) < 0.01 && middle.slow_error < 1e-3,
              "implicit midpoint follows the slow oscillation and lets the fast one ring for ever");
    out.check("two_scales_bdf2", bdf.fast < 1e-15 && bdf.slow_error < 0.02,
              "BDF2 kills the fast oscillation and follows the slow one");

    out.number("two_scales_frame", std::ceil(5000.0 / 60), "", "steps a frame that semi-implicit Euler needs");
    out.number("two_scales_euler", euler.slow_error, "m", "implicit Euler's error of the slow oscillation", 2);
    out.number("two_scales_midpoint", middle.slow_error, "m", "implicit midpoint's", 2);
    out.number("two_scales_bdf2", bdf.slow_error, "m", "BDF2's", 2);

    // A heavy mass on a light chain: twelve powers of ten between the masses.
    using Four = Eigen::Vector4d;
    const Four masses(1e-12, 1e-12, 1e-12, 1);
    const CoupledSprings<double, 4> chain(masses, Eigen::Matrix<double, 5, 1>(4, 4, 4, 4, 0));
    const double fastest = chain.frequencies()[3],
                 slowest = 1;                                      // 4 springs of 4 N/m in a row are one of 1 N/m
    State<Four> start{0, Four(0.25, 0.5, 0.75, 1), Four::Zero()};  // stretched evenly
    const double h = 1.0 / 60;
    const State<Four> implicit = run(implicit_midpoint, chain, start, h, 600);
    const State<Four> explicit_end = run(semi_implicit_euler, chain, start, h, 600);
    const double error = std::hypot(implicit.x[3] - std::cos(slowest * 10), implicit.v[3] + std::sin(10.0));
    std::printf(
        "  a chain of 1e-12 kg links and a mass of 1 kg: fastest oscillation %.3g rad/s, so "
        "semi-implicit\n"
        "  Euler takes %.3g steps a second; implicit midpoint at 60 Hz is %.1e off after 10 s\n",
        fastest, fastest / 2, error);
    out.number("chain_fastest", fastest, "rad/s", "the fastest oscillation of the chain");
    out.number("chain_rate", fastest / 2, "Hz", "steps a second that semi-implicit Euler needs for it");
    out.number("chain_error", error, "m", "implicit midpoint at 60 Hz, after ten seconds", 2);
    out.check("chain", error < 1e-2 && !is_finite(explicit_end),
              "implicit midpoint swings the mass on the chain at 60 Hz, semi-implicit Euler blows up");
}
