// The claims of chapter 3 about stability, energy and the long run.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>
#include "which_method.hpp"

using namespace timestep;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double pi = 3.141592653589793;

template <class Method, class Model>
double limit(const Method& method, const Model& model, double longest = 50) {
    return largest_stable_step([&](double h) { return spectral_radius(step_matrix(method, model, h)) <= 1 + 8 * eps; },
                               longest);
}

template <class Model>
double reach(const Model& model, double h, long steps) {
    double most = 0;
    run(semi_implicit_euler, model, State{0, 1.0, 0.0}, h, steps,
        [&](const auto& s) { most = std::max(most, std::hypot(s.x, s.v)); });
    return most;
}

}  // namespace

TEST_CASE("damping sets explicit Euler's longest step", "[N25][ch3]") {
    for (const double zeta : {0.0, 0.1, 0.5, 0.99, 1.0, 1.01, 1.5, 3.0}) {
        const double expected = zeta <= 1 ? 2 * zeta : 2 / (zeta + std::sqrt(zeta * zeta - 1));
        CHECK(std::fabs(limit(explicit_euler, DampedSpring(1.0, zeta)) - expected) < 1e-6);
    }
}

TEST_CASE("damping the old velocity shortens semi-implicit Euler's longest step, the new lengthens it", "[N25][ch3]") {
    double last_old = 3, last_new = 1;
    for (const double zeta : {0.0, 0.1, 0.5, 1.0, 1.5, 3.0}) {
        const DampedSpring model(1.0, zeta);
        const double old_v = limit(semi_implicit_euler, model), new_v = limit(semi_implicit_euler_new_damping, model);
        CHECK(std::fabs(old_v - 2 * (std::sqrt(1 + zeta * zeta) - zeta)) < 1e-6);
        CHECK(std::fabs(new_v - 2 * (std::sqrt(1 + zeta * zeta) + zeta)) < 1e-6);
        CHECK(old_v < last_old);
        CHECK(new_v > last_new);
        last_old = old_v, last_new = new_v;
    }
}

TEST_CASE("a simulation just inside the limit decays, just outside it grows", "[N25][ch3]") {
    const DampedSpring model(1.0, 0.5);
    const double h = 2 * (std::sqrt(1.25) - 0.5);
    // A tenth of a percent off, an eigenvalue near −1 is off by some 0.001: e^±2 or more in 2000 steps.
    const State inside = run(semi_implicit_euler, model, State{0, 1.0, 0.0}, h * 0.999, 2000);
    const State outside = run(semi_implicit_euler, model, State{0, 1.0, 0.0}, h * 1.001, 2000);
    CHECK(std::hypot(inside.x, inside.v) < 0.5);
    CHECK(std::hypot(outside.x, outside.v) > 2);
}

TEST_CASE("semi-implicit Euler keeps areas and is stable up to omega h = 2", "[N30][ch3]") {
    for (const double wh : {0.1, 1.0, 1.9, 2.5}) {
        const auto matrix = step_matrix(semi_implicit_euler, Spring(1.0), wh);
        CHECK(std::fabs(matrix.determinant() - 1) <= 4 * eps * (1 + wh * wh));
    }
    CHECK(std::fabs(limit(semi_implicit_euler, Spring(1.0)) - 2) < 1e-6);
    CHECK(std::fabs(limit(semi_implicit_euler, Spring(40.0)) - 2 / 40.0) < 1e-6 / 40);
}

TEST_CASE("10,000 steps tell omega h = 2 from outside to a millionth", "[N30][ch3]") {
    // At 2 − δ the ellipse reaches √(2/δ), which is 1414 for a millionth; at 2 the growth is linear, 2√2 a
    // step, and reaches 2.8·10⁴. At 2 + δ it grows by e^(2√δ) a step: over 10⁴ steps by e²⁰ on the way to 10⁵ and more.
    const double found = largest_stable_step([](double wh) { return reach(Spring(1.0), wh, 10000) < 1e5; }, 3.0);
    CHECK(std::fabs(found - 2) < 1e-6);
}

TEST_CASE("semi-implicit Euler keeps its own energy, and the true one stays in a band", "[N31][ch3]") {
    for (const double wh : {0.1, 1.0, 1.7}) {
        const double omega = 10, h = wh / omega;
        const Spring spring(omega);
        const State start{0, 1.0, 0.0};
        const auto kept = [&](const State<double>& s) { return spring.energy(s) - h * omega * omega * s.x * s.v / 2; };
        double drift = 0, least = 1e9, most = 0, sum = 0;
        const long steps = 1000000;
        run(semi_implicit_euler, spring, start, h, steps, [&](const auto& s) {
            const double energy = spring.energy(s) / spring.energy(start);
            drift = std::max(drift, std::fabs(kept(s) / kept(start) - 1));
            least = std::min(least, energy), most = std::max(most, energy), sum += energy;
        });
        // The roundings of 10⁶ steps add up like a random walk, some 6 ε √n; ten of its deviations, and on
        // the thin ellipse the terms of the sum are (1 + ωh/2)/(1 − ωh/2) times its value.
        const double thin = (1 + wh / 2) / (1 - wh / 2);
        CHECK(drift < 10 * 6 * eps * std::sqrt(double(steps)) * thin);
        // On ½v² + ½ω²x² − ½hω²xv = E₀ the quotient ωxv/(v² + ω²x²) lies between −½ and ½.
        CHECK(least >= (1 - 1e-9) / (1 + wh / 2));
        CHECK(most <= (1 + 1e-9) / (1 - wh / 2));
        CHECK(most > 1 + wh / 4);  // the band is real: "on average" is not "constant"
        // A sum of cosines over n steps is at most 1/|sin θ| of their size: the mean is off by that over n.
        const double theta = std::acos(1 - wh * wh / 2);
        CHECK(std::fabs(sum / (steps + 1) - 1 / (1 - wh * wh / 4)) <
              4 * most / std::fabs(std::sin(theta)) / steps + 100 * drift);
    }
}

// Stepped by hand, with v = h ẋ: of the pendulum's ωh only the square is left.
TEST_CASE("a pendulum keeps its energy in the spring's band at half the advised step, and not at all of it",
          "[N31][ch3]") {
    const auto swing = [](double start, double wh, long steps) {
        struct {
            double least = 1, most = 1, farthest = 0;
        } found;
        double x = start, v = 0;
        const auto energy = [&] { return v * v / (wh * wh) / 2 + 1 - std::cos(x); };
        const double first = energy();
        for (long n = 0; n < steps; ++n) {
            v -= wh * wh * std::sin(x);
            x += v;
            found.least = std::min(found.least, energy() / first), found.most = std::max(found.most, energy() / first);
            found.farthest = std::max(found.farthest, std::fabs(x));
        }
        return found;
    };
    const double calm = pendulum_turn;
    for (const double start : {0.05, 0.3, 1.0, 1.7, 2.4, 3.0, 3.1}) {
        CAPTURE(start);
        const auto found = swing(start, calm, 50000);
        CHECK(found.least > 1 / (1 + calm / 2));
        CHECK(found.most < 1 / (1 - calm / 2));
        CHECK(found.farthest < pi);
    }
    // The true one, let go at rest, never comes higher than it was.
    const auto wild = swing(3.1, alive_turn, 1000000);
    CHECK(wild.farthest > 2 * pi);
    CHECK(wild.most > 2);
    // Of starts a tenth of a radian apart: the last that stays, the next goes over the top.
    const auto goes_over = [&](double start, double wh) { return swing(start, wh, 100000).farthest > pi + 1; };
    for (const auto& [wh, last] : {std::pair(1.0, 2.2), {0.9, 2.6}, {0.8, 2.8}, {0.7, 2.9}, {0.6, 3.0}}) {
        CAPTURE(wh);
        CHECK(!goes_over(last, wh));
        CHECK(goes_over(last + 0.1, wh));
    }
}

// Three soft constraints at one mass in a plane, one after another: each alone shrinks, together they blow up.
TEST_CASE("a soft constraint alone cannot blow up, three at one mass can", "[ch3]") {
    struct Soft {
        double degrees, omega, zeta;
    };
    const double h = 1.0 / 60;
    const auto farthest = [&](const std::vector<Soft>& all) {
        double x[] = {1, 0}, v[] = {0, 0}, most = 0;
        for (int step = 0; step < 60; ++step) {
            for (const Soft& soft : all) {
                const double n[] = {std::cos(soft.degrees * pi / 180), std::sin(soft.degrees * pi / 180)};
                const double k = soft.omega * soft.omega, c = 2 * soft.zeta * soft.omega;
                const double along = n[0] * v[0] + n[1] * v[1], off = n[0] * x[0] + n[1] * x[1];
                const double after = (along - h * k * off) / (1 + h * c + h * h * k);  // implicit Euler
                for (int i = 0; i < 2; ++i) v[i] += (after - along) * n[i];
            }
            for (int i = 0; i < 2; ++i) x[i] += h * v[i];
            most = std::max(most, std::hypot(x[0], x[1]));
        }
        return most;
    };
    const Soft one{20, 300, 0.1}, two{45, 30, 20}, three{0, 300, 0.1};
    for (const Soft& alone : {one, two, three}) CHECK(farthest({alone}) < 1.5);
    CHECK(farthest({one, two, three}) > 1000);
}

TEST_CASE("explicit Euler gains energy for ever, implicit Euler loses it", "[N31][ch3]") {
    const Spring spring(10.0);
    double before_e = 0, before_i = 1e9;
    run(explicit_euler, spring, State{0, 1.0, 0.0}, 0.01, 500, [&](const auto& s) {
        CHECK(spring.energy(s) > before_e);
        before_e = spring.energy(s);
    });
    run(implicit_euler, spring, State{0, 1.0, 0.0}, 0.01, 500, [&](const auto& s) {
        CHECK(spring.energy(s) < before_i);
        before_i = spring.energy(s);
    });
}

TEST_CASE("the portraits stay on their ellipse below the limit and leave it above", "[N32][ch3]") {
    for (const double wh : {0.1, 0.5, 1.0, 1.5, 1.9, 1.99}) {
        // ½v² + ½x² − ½wh xv = ½ reaches farthest where x = v: x² + v² = 1/(1 − wh/2).
        const double farthest = 1 / std::sqrt(1 - wh / 2);
        CHECK(reach(Spring(1.0), wh, 100000) <= farthest * (1 + 1e-9));
        CHECK(reach(Spring(1.0), wh, 100000) >= farthest * 0.99);  // and comes close to it
    }
    // At 2.01 the eigenvalue is −1.22.
    CHECK(reach(Spring(1.0), 2.01, 100) > 1e7);
}

TEST_CASE("the stepped spring turns by arccos(1 - (omega h)^2/2) a step", "[N32][ch3]") {
    for (const double wh : {0.1, 0.5, 1.0, 1.5, 1.9, 1.99}) {
        const auto matrix = step_matrix(semi_implicit_euler, Spring(1.0), wh);
        CHECK(std::fabs(matrix.trace() / 2 - (1 - wh * wh / 2)) < 4 * eps);
        // Measured: the swings in 10⁵ steps, from one rise through zero to another, each seen at most one
        // step late.
        long swings = -1;
        double first = 0, last = 0, before = 1;
        long n = 0;
        run(semi_implicit_euler, Spring(1.0), State{0, 1.0, 0.0}, wh, 100000, [&](const auto& s) {
            if (before < 0 && s.x >= 0) {
                last = double(n);
                if (swings < 0) first = last;
                ++swings;
            }
            before = s.x, ++n;
        });
        CHECK(std::fabs((last - first) / swings - 2 * pi / std::acos(1 - wh * wh / 2)) < 1.0 / swings);
    }
}

TEST_CASE("four steps a period are stable, three are not, and the limit is pi", "[N33][ch3]") {
    const auto radius = [](double steps) {
        return spectral_radius(step_matrix(semi_implicit_euler, Spring(1.0), 2 * pi / steps));
    };
    CHECK(radius(4) <= 1 + 8 * eps);
    CHECK(radius(3) > 1.5);
    CHECK(std::fabs(2 * pi / limit(semi_implicit_euler, Spring(1.0)) - pi) < 1e-6);
    CHECK(reach(Spring(1.0), 2 * pi / 4, 100000) < 3);
    CHECK(reach(Spring(1.0), 2 * pi / 3, 1000) > 1e100);
}

TEST_CASE("extrapolation spreads areas, interpolation shrinks them, the mixture keeps them", "[N34][ch3]") {
    for (const double wh : {0.01, 0.5, 1.0, 3.0}) {
        const Spring spring(1.0);
        const double spread = 1 + wh * wh;
        CHECK(std::fabs(step_matrix(explicit_euler, spring, wh).determinant() - spread) < 4 * eps * spread);
        CHECK(std::fabs(step_matrix(implicit_euler, spring, wh).determinant() - 1 / spread) < 8 * eps);
        CHECK(std::fabs(step_matrix(semi_implicit_euler, spring, wh).determinant() - 1) < 4 * eps * spread);
    }
}

TEST_CASE("the stepped spring is a sampled cosine", "[N37][ch3]") {
    for (const double wh : {0.05, 0.3, 1.2}) {
        const double theta = std::acos(1 - wh * wh / 2);
        const State start{0, 1.0, 0.3};
        const double x1 = semi_implicit_euler.step(Spring(1.0), start, wh).x;
        const double a_sin = (start.x * std::cos(theta) - x1) / std::sin(theta);
        const double a = std::hypot(start.x, a_sin), phi = std::atan2(a_sin, start.x);
        double worst = 0;
        long n = 0;
        const long steps = 1000000;
        run(semi_implicit_euler, Spring(1.0), start, wh, steps, [&](const auto& s) {
            worst = std::max(worst, std::fabs(s.x - a * std::cos(n * theta + phi)));
            ++n;
        });
        // θ = arccos(c) is known to ε/sin θ, and so is the angle that a rounded step turns by; in n steps
        // both errors grow to at most n times a few of that.
        CHECK(worst < a * 8 * eps / std::sin(theta) * double(steps));
    }
}
