// The mass-spring-damper: ζ below, at and above 1.

#include <cmath>
#include <cstdio>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr int samples = 2000;

// The last time at which x is more than 5 % of its start away from equilibrium.
double settling_time(const DampedSpring<double>& legs, const State<double>& start, double seconds) {
    for (int i = samples; i > 0; --i)
        if (std::fabs(legs.exact(start, seconds * i / samples).x) > 0.05 * std::fabs(start.x))
            return seconds * i / samples;
    return 0;
}

int crossings(const DampedSpring<double>& legs, const State<double>& start, double seconds) {
    int count = 0;
    double before = start.x;
    for (int i = 1; i <= samples; ++i) {
        const double x = legs.exact(start, seconds * i / samples).x;
        if (x == 0) continue;
        if ((x < 0) != (before < 0)) ++count;
        before = x;
    }
    return count;
}

// One curve a damping ratio, all let go from the same place.
void family(double omega, lab::Findings& out) {
    const double seconds = 6 * pi / omega;
    const State start{0, dip, 0.0};
    double at_07 = 0, at_1 = 0;
    std::printf("    zeta  crosses zero  within 5 %% after\n");
    for (const double zeta : {0.0, 0.1, 0.3, 0.7, 1.0, 3.0}) {
        const DampedSpring legs(omega, zeta);
        char file[32];
        std::snprintf(file, sizeof file, "zeta_%g.tsv", zeta);
        auto& table = out.table(file, {"t", "x"});
        for (int i = 0; i <= 300; ++i) {
            const State s = legs.exact(start, seconds * i / 300);
            table.row({s.t, s.x});
        }
        const int count = crossings(legs, start, seconds);
        const double settled = settling_time(legs, start, seconds);
        if (zeta == 0.7) at_07 = settled;
        if (zeta == 1.0) at_1 = settled;
        if (settled < seconds)
            std::printf("    %4g  %7d times  %10.2f s\n", zeta, count, settled);
        else
            std::printf("    %4g  %7d times  later than %.2f s\n", zeta, count, seconds);
        if (zeta >= 1)
            out.check(zeta == 1 ? "critical_no_swing" : "overdamped_no_swing", count == 0,
                      "let go at rest, a mass with zeta >= 1 never crosses zero");
    }
    out.number("settled_07", at_07, "s", "time to come and stay within 5 % at a damping ratio of 0.7");
    out.number("settled_1", at_1, "s", "the same at critical damping");
    out.check("softer_settles_sooner", at_07 < at_1,
              "a damping ratio of 0.7 settles to 5 % sooner than critical damping");
}

void spiral(const Settings& settings, lab::Findings& out) {
    const DampedSpring legs = settings.legs();
    const State start{0, dip, 0.0};
    auto& table = out.table("spiral.tsv", {"t", "x", "v_over_omega"});
    const double seconds = 8 * settings.period();
    for (int i = 0; i <= 800; ++i) {
        const State s = legs.exact(start, seconds * i / 800);
        table.row({s.t, s.x, s.v / legs.omega});
    }
    auto& arrows = out.table("spiral_arrows.tsv", {"x", "v_over_omega", "dx", "dv"});
    for (int i = 0; i < 6; ++i) {
        const State s = legs.exact(start, settings.period() * (i + 0.5) / 3);
        const Rate<double> r = rate(legs, s);
        const double length = std::hypot(r.x, r.v / legs.omega);
        arrows.row({s.x, s.v / legs.omega, 0.05 * r.x / length, 0.05 * r.v / legs.omega / length});
    }
    const double left = legs.exact(start, settings.period()).x / start.x;
    std::printf(
        "  the character's legs: zeta = %.3g;\n"
        "  after %.3f s, %.0f %% of the amplitude is left\n",
        legs.zeta, settings.period(), 100 * std::fabs(left));
    out.number("zeta", legs.zeta, "", "damping ratio of the character's legs");
    out.number("damping", settings.damping, "N·s/m", "damping of its legs");
    out.number("left_after_a_swing", 100 * std::fabs(left), "%", "what is left of the amplitude after a time of 2π/ω",
               2);
}

// A legend that is easily told too simply: beyond ζ = 1 the solution is a sum of two exponentials,
//     x = ((v₀ + q x₀) e^(−pt) − (v₀ + p x₀) e^(−qt)) / (q − p),
// and where v₀ throws the mass at the equilibrium faster than q x₀, the brackets have the same sign
// and x is zero once, at t = log((v₀ + p x₀) / (v₀ + q x₀)) / (q − p).
void zero_crossing(double omega, lab::Findings& out) {
    const double zeta = 1.2;
    const DampedSpring legs(omega, zeta);
    const double root = std::sqrt(zeta * zeta - 1);
    const double p = omega * (zeta - root), q = omega * (zeta + root);
    const double seconds = 8 / omega;
    std::printf("  zeta = %g, thrown at the equilibrium with v0 = -c q x0:\n", zeta);
    for (const double factor : {0.0, 0.8, 2.0}) {
        const State start{0, dip, -factor * q * dip};
        char file[32];
        std::snprintf(file, sizeof file, "thrown_%g.tsv", factor);
        auto& table = out.table(file, {"t", "x"});
        for (int i = 0; i <= 400; ++i) {
            const State s = legs.exact(start, seconds * i / 400);
            table.row({s.t, s.x});
        }
        const int count = crossings(legs, start, seconds);
        std::printf("    c = %-4g crosses zero %d times\n", factor, count);
        if (factor < 1)
            out.check(factor == 0 ? "let_go_stays" : "slow_throw_stays", count == 0,
                      "thrown slower than q x0, the overdamped mass does not cross zero");
        else {
            const double when = std::log((start.v + p * dip) / (start.v + q * dip)) / (q - p);
            out.number("crossing_zeta", zeta, "", "damping ratio of the throws");
            out.number("crossing_time", when, "s", "when the fast throw crosses zero");
            out.number("crossing_speed", q * dip, "m/s", "the speed q x0 beyond which it crosses", 4);
            out.number("thrown_speed", -start.v, "m/s", "speed of the throw that crosses", 4);
            out.check("crosses_once", count == 1, "thrown faster than q x0, it crosses zero once");
            out.check("crossing_predicted", std::fabs(legs.exact(start, when).x) < 1e-14 * dip,
                      "it crosses zero at the predicted time");
        }
    }
}

// Near ζ = 1 the two exponentials become one, and the formula of the textbook, two constants and
// two exponentials, subtracts what is nearly equal.
double textbook(double omega, double zeta, double x0, double t) {
    const double root = std::sqrt(zeta * zeta - 1);
    const double p = omega * (zeta - root), q = omega * (zeta + root);
    return q * x0 / (q - p) * std::exp(-p * t) - p * x0 / (q - p) * std::exp(-q * t);
}

void near_critical(double omega, lab::Findings& out) {
    const State start{0, dip, 0.0};
    const double t = 3 / omega;
    auto& table = out.table("near_critical.tsv", {"zeta_minus_1", "textbook", "ours"});
    double worst_ours = 0, worst_textbook = 0;
    for (double exponent = -15; exponent <= -1; exponent += 0.125) {
        const double zeta = 1 + std::pow(10, exponent);
        const DampedSpring<long double> reference(omega, zeta);
        const double exact = static_cast<double>(reference.exact(State<long double>{0, dip, 0}, t).x);
        const double ours = std::fabs(DampedSpring(omega, zeta).exact(start, t).x / exact - 1);
        const double theirs = std::fabs(textbook(omega, zeta, dip, t) / exact - 1);
        table.row({zeta - 1, theirs, ours});
        worst_ours = std::max(worst_ours, ours);
        worst_textbook = std::max(worst_textbook, theirs);
    }
    std::printf(
        "  near zeta = 1, exact() is at most %.1e off,\n"
        "  the textbook's formula up to %.1e\n",
        worst_ours, worst_textbook);
    out.number("near_critical_ours", worst_ours, "", "largest relative error of exact() near zeta = 1", 2);
    out.number("near_critical_textbook", worst_textbook, "", "the textbook formula's", 2);
    // At ωt = 3 the exponent pt = 3 is rounded three times and the terms some ten times: 10 ε.
    out.check("accurate_near_critical", worst_ours < 10 * 2.3e-16, "exact() keeps its digits as zeta -> 1");
}

// The film: kicked once in a while, the mass rings down, and is kicked again. After some kicks the
// motion repeats itself, so the film closes.
void film(const Settings& settings, lab::Findings& out) {
    const DampedSpring legs = settings.legs();
    const double swings = 5;  // between two kicks
    const double seconds = swings * settings.period();
    const double kick = dip * legs.omega;
    State<double> start{0, 0, 0};
    for (int i = 0; i < 50; ++i) {
        start.v += kick;
        start = {0, legs.exact(start, seconds).x, legs.exact(start, seconds).v};
    }
    start.v += kick;
    // One round before the film, which the strip shows, and the round of the film.
    auto& table = out.table("damping_film.tsv", {"t", "x", "v_over_omega"});
    const int rows = 240;
    for (int i = -rows; i < rows; ++i) {
        const State s = legs.exact(start, seconds * ((i + rows) % rows) / rows);
        table.row({swings * i / rows, s.x, s.v / legs.omega});
    }
}

}  // namespace

void damping(const Settings& settings, lab::Findings& out) {
    out.section("Damping");
    family(settings.omega(), out);
    spiral(settings, out);
    zero_crossing(settings.omega(), out);
    near_critical(settings.omega(), out);
    film(settings, out);
}
