// Van der Pol's jumps and Robertson's reaction: two classics that no explicit method likes.

#include <cmath>
#include <cstdio>
#include <string>

#include <Eigen/Dense>

#include <timestep/models/robertson.hpp>
#include <timestep/models/van_der_pol.hpp>

#include "adaptive.hpp"
#include "any_method.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

using Pair = Eigen::Vector2d;
using Shares = Eigen::Vector3d;
using OnVanDerPol = AnyMethod<VanDerPol<double>, FirstOrder<Pair>>;
using OnRobertson = AnyMethod<Robertson<double>, FirstOrder<Shares>>;

std::string words(const char* format, double value) {
    char text[24];
    std::snprintf(text, sizeof text, format, value);
    return std::isfinite(value) ? text : "gone";
}

// When implicit Euler with steps of 2/steps s first returns what is no root of its own equation
// x₂ = x₁ + h v₂: Newton–Raphson has stopped where the error is least, and not zero.
double first_without_root(long steps) {
    const VanDerPol<double> oscillator(1e6);
    const double h = 2 / double(steps);
    FirstOrder<Pair> state{0, Pair(2, 0)};
    for (long i = 0; i < steps; ++i) {
        const FirstOrder<Pair> next = implicit_euler.step(oscillator, state, h);
        if (std::fabs(next.y(0) - state.y(0) - h * next.y(1)) > 1e-6) return state.t;
        state = next;
    }
    return 2;
}

// How often x goes through zero with so many even steps of implicit Euler: each is a jump.
long jumps_of_even_steps(long steps) {
    double before = 2;
    long jumps = 0;
    run(OnVanDerPol(implicit_euler), VanDerPol<double>(1e6), FirstOrder<Pair>{0, Pair(2, 0)}, 2 / double(steps), steps,
        [&](const auto& s) {
            jumps += before * s.y(0) < 0;
            before = s.y(0);
        });
    return jumps;
}

// The references at t = 2 and at t = 1e11 were computed for the Test Set for IVP Solvers (F. Mazzia
// and C. Magherini, Bari) by RADAU with 19 digits. That at t = 40 agrees to 1e-6 with two runs in
// the tests, by different methods.
const Pair van_der_pol_at_2(1.706167732170483, -0.8928097010247975);
const Shares robertson_at_40(0.7158270687193941, 0.9185534764558135e-5, 0.2841637457458413);
const Shares robertson_at_1e11(0.2083340149701255e-7, 0.8333360770334713e-13, 0.9999999791665050);

// The same as a force, for semi-implicit Euler. It depends on v, so Verlet's kind does not take it;
// and it is not linear, so new damping does not.
struct VanDerPolForce {
    double mu;
    double acceleration(double x, double v) const { return mu * ((1 - x * x) * v - x); }
};

double semi_implicit_steps(double count, lab::Table& table) {
    const auto end = run(semi_implicit_euler, VanDerPolForce{1e6}, State<double>{0, 2, 0}, 2 / count, long(count));
    const double error = std::fabs(end.x - van_der_pol_at_2(0));
    std::printf("  %-28s %8.0f steps: %s\n", "semi-implicit Euler", count, words("%.1e off", error).c_str());
    table.row({std::string("semi-implicit Euler"), count, words("%.1e", error)});
    return error;
}

double fixed_steps(const OnVanDerPol& method, const std::string& note, double count, lab::Table& table,
                   lab::Table* curve) {
    const VanDerPol<double> oscillator(1e6);
    const auto steps = long(count);
    const FirstOrder<Pair> end =
        run(method, oscillator, FirstOrder<Pair>{0, Pair(2, 0)}, 2 / count, steps, [&](const FirstOrder<Pair>& s) {
            if (curve) curve->row({s.t, s.y(0)});
        });
    const double error = std::fabs(end.y(0) - van_der_pol_at_2(0));
    std::printf("  %-28s %8ld steps: %s\n", note.c_str(), steps, words("%.1e off", error).c_str());
    table.row({note, double(steps), words("%.1e", error)});
    return error;
}

void van_der_pol(lab::Findings& out) {
    std::printf("  Van der Pol, mu = 1e6, from t = 0 to 2:\n");
    auto& table = out.table("van_der_pol.tsv", {"method", "steps", "error at t = 2"});
    const double four = fixed_steps(explicit_euler, "explicit Euler", 4.5e6, table, nullptr);
    const double six = fixed_steps(explicit_euler, "explicit Euler", 6e6, table, nullptr);
    const double semi = semi_implicit_steps(6e6, table);
    const double middle_few = fixed_steps(midpoint, "midpoint", 3e6, table, nullptr);
    const double middle_many = fixed_steps(midpoint, "midpoint", 6e6, table, nullptr);
    const double heun_few = fixed_steps(heun, "Heun", 3e6, table, nullptr);
    const double heun_many = fixed_steps(heun, "Heun", 6e6, table, nullptr);
    const double few = fixed_steps(runge_kutta_4, "Runge-Kutta 4", 2e6, table, nullptr);
    const double many = fixed_steps(runge_kutta_4, "Runge-Kutta 4", 4e6, table, nullptr);
    const double euler =
        fixed_steps(implicit_euler, "implicit Euler", 2000, table, &out.table("van_der_pol_fixed.tsv", {"t", "x"}));
    const double longer = fixed_steps(implicit_euler, "implicit Euler", 200000, table, nullptr);
    const double turned = fixed_steps(implicit_midpoint, "implicit midpoint", 200000, table, nullptr);
    const double bdf = fixed_steps(bdf2, "BDF2", 200000, table, nullptr);

    const long even_jumps = jumps_of_even_steps(200000);
    std::printf("  with 200000 steps implicit Euler jumps %ld times\n", even_jumps);

    const double stuck = first_without_root(2000);
    std::printf("  with 2000 steps Newton-Raphson finds no root from t = %.3f s on, at the jump\n", stuck);
    const VanDerPol<double> oscillator(1e6);
    Account account;
    auto& curve = out.table("van_der_pol_adaptive.tsv", {"t", "x"});
    long jumps = 0;
    double before = 2;
    const FirstOrder<Pair> end =
        run_adaptive(oscillator, FirstOrder<Pair>{0, Pair(2, 0)}, 2.0, 1e-4, 1e-4, account, [&](const auto& s) {
            curve.row({s.t, s.y(0)});
            jumps += before * s.y(0) < 0;
            before = s.y(0);
        });
    const double error = std::fabs(end.y(0) - van_der_pol_at_2(0));
    std::printf("  %-28s %8ld steps: %.1e off; they are %.0e to %.0e s long\n", "implicit Euler, adaptive",
                account.steps, error, account.shortest, account.longest);
    table.row({std::string("implicit Euler, adaptive"), double(account.steps), words("%.1e", error)});
    out.number("vdp_even", 2000, "", "even steps of the implicit methods");
    out.number("vdp_even_many", 200000, "", "a hundred times as many");
    out.number("vdp_adaptive_steps", double(account.steps), "", "adaptive steps");
    out.number("vdp_adaptive_error", error, "", "error of the adaptive run", 2);
    out.number("vdp_even_jumps", double(even_jumps), "", "jumps with 200000 even steps");
    out.number("vdp_true_jumps", double(jumps), "", "jumps of the adaptive run");
    out.check("vdp_jumps", jumps == 2 && even_jumps > 2 * jumps,
              "with 200000 even steps implicit Euler jumps far more often than the adaptive run");
    out.number("vdp_shortest", account.shortest, "s", "its shortest step", 1);
    out.number("vdp_longest", account.longest, "s", "its longest step", 1);
    out.check("vdp_explicit",
              !std::isfinite(four) && std::isfinite(six) && std::isfinite(semi) && six > 1 && semi > 1 &&
                  !std::isfinite(middle_few + heun_few) && middle_many < 0.1 && heun_many < 0.1 &&
                  !std::isfinite(few) && many < 0.01,
              "every explicit method takes millions of steps not to blow up, and those of order one are "
              "wrong with six million");
    out.check("vdp_fixed_lost",
              euler > 0.1 && longer > 0.1 && turned > 0.1 && bdf > 0.1 && std::isfinite(euler + longer + turned + bdf),
              "with steps of one length no implicit method blows up, and none follows the jumps");
    // On the creep v = x/(1 − x²): from x = 2 to 1 it takes ∫ (x − 1/x) dx = 3/2 − ln 2.
    out.number("vdp_stuck", stuck, "s", "Newton-Raphson finds no root from here on, 2000 steps");
    out.check("vdp_no_root", std::fabs(stuck - (1.5 - std::log(2))) < 0.01,
              "with 2000 steps Newton-Raphson loses the root where the creep ends");
    out.check("vdp_adaptive", error < 1e-3, "with a step that adapts implicit Euler meets the published value");
}

double react(const OnRobertson& method, double count, lab::Table& table) {
    const char* name = method.name;
    const Robertson<double> reaction;
    const auto end = run(method, reaction, FirstOrder<Shares>{0, Shares(1, 0, 0)}, 40 / count, long(count));
    const double error = (end.y - robertson_at_40).cwiseAbs().maxCoeff();
    const double lost = std::fabs(end.y.sum() - 1);
    std::printf("  %-28s %8.0f steps: %s\n", name, count, words("%.1e off", error).c_str());
    table.row({std::string(name), std::string("40"), count, words("%.1e", error)});
    return std::isfinite(error) ? std::max(error, lost < 1e-12 ? 0 : 1e300) : error;
}

void robertson(lab::Findings& out) {
    std::printf("  Robertson, from t = 0 to 40:\n");
    auto& table = out.table("robertson.tsv", {"method", "to t", "steps", "error"});
    const double few = react(explicit_euler, 6e4, table);
    const double many = react(explicit_euler, 8e4, table);
    bool explicit_fails = !std::isfinite(few), explicit_arrives = many < 1e-4;
    const auto both = [&](const OnRobertson& method) {
        explicit_fails &= !(react(method, 4e4, table) < 1e-3);
        explicit_arrives &= react(method, 8e4, table) < 1e-4;
    };
    both(midpoint), both(heun), both(runge_kutta_4);
    const double euler = react(implicit_euler, 400, table);
    const double turned = react(implicit_midpoint, 400, table);
    const double bdf = react(bdf2, 400, table);

    const Robertson<double> reaction;
    Account account;
    const auto end =
        run_adaptive(reaction, FirstOrder<Shares>{0, Shares(1, 0, 0)}, 1e11, 1e-4, 1e-14, account, [](const auto&) {});
    const double error = (end.y - robertson_at_1e11).cwiseQuotient(robertson_at_1e11).cwiseAbs().maxCoeff();
    // Two of the three eigenvalues are nearly zero, so the trace is the third: it sets the step.
    const double explicit_steps = 1e11 * -reaction.slope_y(0.0, end.y).trace() / 2;
    const double days = explicit_steps / 1e8 / 86400;  // at 1e8 steps a second
    std::printf(
        "  to t = 1e11 adaptive implicit Euler takes %ld steps, %.0e to %.0e s long, and is %.1e "
        "of\n"
        "  each share off; an explicit method would need %.0e\n",
        account.steps, account.shortest, account.longest, error, explicit_steps);
    table.row(
        {std::string("implicit Euler, adaptive"), std::string("10¹¹"), double(account.steps), words("%.1e", error)});
    out.number("robertson_few", 6e4, "", "explicit steps to t = 40 that are too few");
    out.number("robertson_even", 400, "", "implicit steps to t = 40");
    out.number("robertson_adaptive_steps", double(account.steps), "", "adaptive steps to t = 1e11");
    out.number("robertson_error", 100 * error, "%", "largest error of a share at t = 1e11", 2);
    out.number("robertson_longest", account.longest, "s", "the longest step", 1);
    out.number("robertson_explicit_steps", explicit_steps, "", "steps of an explicit method to t = 1e11", 1);
    out.number("robertson_days", days, "d", "that many at 1e8 steps a second", 2);
    out.check("robertson_explicit", explicit_fails && explicit_arrives,
              "with 40000 steps to t = 40 explicit methods are gone or far off, explicit Euler "
              "with 60000 "
              "too; with 80000 they arrive");
    out.check("robertson_implicit", euler < 1e-3 && turned < 1e-3 && bdf < 1e-3 && bdf < euler,
              "400 steps do for every implicit method, and no share is lost");
    out.check("robertson_long", error < 1e-3 && std::fabs(end.y.sum() - 1) < 1e-12,
              "adaptive implicit Euler arrives at t = 1e11, where the published value is");
}

}  // namespace

void reactions(const Settings&, lab::Findings& out) {
    out.section("Jumps and a reaction");
    van_der_pol(out);
    robertson(out);
}
