// A slow motion with a fast pull towards it: what is left of a method's order.

#include <cmath>
#include <cstdio>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods.hpp>
#include <timestep/models/prothero_robinson.hpp>
#include <timestep/run.hpp>

#include "sdirk.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double stiff = -1e6;  // 1/s

// The error after a second.
template <class Method>
double error(const Method& method, double lambda, long steps) {
    const ProtheroRobinson<double> model(lambda);
    return std::fabs(run(method, model, FirstOrder<double>{0, 1}, 1.0 / double(steps), steps).y - std::cos(1.0));
}

// The same when the steps are a quarter longer and a quarter shorter by turns.
template <class Method>
double uneven_error(const Method& method, double lambda, long steps) {
    const ProtheroRobinson<double> model(lambda);
    FirstOrder<double> state{0, 1};
    for (long i = 0; i < steps; ++i) state = method.step(model, state, (i % 2 == 0 ? 1.25 : 0.75) / double(steps));
    return std::fabs(state.y - std::cos(1.0));
}

}  // namespace

void prothero_robinson(const Settings&, lab::Findings& out) {
    out.section("A slow motion with a fast pull");
    auto& table = out.table(
        "prothero.tsv", {"h", "implicit_euler", "bdf2", "implicit_midpoint", "midpoint_uneven", "sdirk", "sdirk_mild"});
    std::vector<double> h, euler, bdf, even, uneven, sdirk, mild;
    // With steps shorter than these implicit midpoint begins to forget where it started.
    for (long n = 10; n <= 160; n *= 2) {
        h.push_back(1 / double(n));
        euler.push_back(error(implicit_euler, stiff, n));
        bdf.push_back(error(bdf2, stiff, n));
        even.push_back(error(implicit_midpoint, stiff, n));
        uneven.push_back(uneven_error(implicit_midpoint, stiff, n));
        sdirk.push_back(error(sdirk_3, stiff, n));
        mild.push_back(error(sdirk_3, -1.0, n));
        table.row({h.back(), euler.back(), bdf.back(), even.back(), uneven.back(), sdirk.back(), mild.back()});
    }
    auto& orders = out.table("prothero_orders.tsv", {"method", "its order", "measured at λ = −10⁶", "error at 60 Hz"});
    double found[5];
    int i = 0;
    const auto row = [&](const char* name, const char* id, int order, const std::vector<double>& errors, double at_60) {
        found[i++] = measured_order(h, errors);
        std::printf("  %-30s order %d, measured %5.2f; at 60 Hz %.1e off\n", name, order, found[i - 1], at_60);
        char measured[16], off[16];
        std::snprintf(measured, sizeof measured, "%.2f", found[i - 1]);
        std::snprintf(off, sizeof off, "%.1e", at_60);
        orders.row({std::string(name), double(order), std::string(measured), std::string(off)});
        out.number(std::string("prothero_60_") + id, at_60, "", "error after a second at 60 Hz", 2);
    };
    const double euler_60 = error(implicit_euler, stiff, 60), midpoint_60 = error(implicit_midpoint, stiff, 60);
    const double uneven_60 = uneven_error(implicit_midpoint, stiff, 60);
    row("implicit Euler", "euler", 1, euler, euler_60);
    row("BDF2", "bdf2", 2, bdf, error(bdf2, stiff, 60));
    row("implicit midpoint", "midpoint", 2, even, midpoint_60);
    row("implicit midpoint, uneven steps", "uneven", 2, uneven, uneven_60);
    row("SDIRK", "sdirk", 3, sdirk, error(sdirk_3, stiff, 60));
    const double mild_order = measured_order(h, mild);
    std::printf("  with lambda = -1 SDIRK's measured order is %.2f\n", mild_order);
    out.number("prothero_order_sdirk", found[4], "", "SDIRK's measured order with the stiff pull");
    out.number("prothero_order_mild", mild_order, "", "SDIRK's measured order with a mild pull");

    const auto near = [](double a, double b) { return std::fabs(a - b) < 0.1; };
    out.check("prothero_keeps", near(found[0], 1) && near(found[1], 2) && near(found[2], 2),
              "with even steps implicit Euler, BDF2 and implicit midpoint keep their orders");
    out.check("prothero_uneven", near(found[3], 1), "with steps that alternate implicit midpoint falls to order one");
    out.check("prothero_reduction", near(mild_order, 3) && near(found[4], 2),
              "SDIRK falls from order three to two where the pull is stiff");
    out.check("prothero_euler_wins", euler_60 < midpoint_60 / 100 && midpoint_60 < uneven_60 / 10,
              "at 60 Hz implicit Euler is a hundred times nearer than implicit midpoint, and that "
              "ten times "
              "nearer than with uneven steps");

    out.check("prothero_sdirk_worse", error(sdirk_3, stiff, 60) > 1000 * euler_60,
              "at 60 Hz SDIRK, of order three, is over a thousand times as far off as implicit Euler");

    // Without the pull's limit |R(hλ)| ≤ 1, which for RK4 ends at hλ = −2.785, nothing explicit
    // stands.
    const double needed = 2 / -stiff;
    bool fits = true, misses = true;
    const auto at_limit = [&](const auto& method, double limit) {
        const double steps = -stiff / limit;
        const double fitting = error(method, stiff, std::lround(1.01 * steps));
        const double missing = error(method, stiff, std::lround(0.99 * steps));
        std::printf("  %-18s with %6.0f steps %.0e off, with two percent fewer %s\n", method.name, 1.01 * steps,
                    fitting, missing < 1 ? "off a little" : "gone");
        fits &= fitting < 1e-5;
        misses &= !(missing < 1e3);
    };
    at_limit(explicit_euler, 2), at_limit(midpoint, 2), at_limit(heun, 2), at_limit(runge_kutta_4, 2.7852936);
    out.number("prothero_frame", std::ceil(1 / needed / 60), "", "steps per frame that explicit Euler needs");
    out.check("prothero_explicit", fits && misses,
              "an explicit method blows up unless its step is as short as the pull asks for");
}
