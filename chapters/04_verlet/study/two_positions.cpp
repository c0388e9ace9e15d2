// Plain Verlet is semi-implicit Euler without the velocity: the same positions, but for rounding.

#include <algorithm>
#include <cstdio>
#include <limits>

#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/methods/verlet.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

const State<double> start{0, 1.0, 0.0};

// Calls look(n, exact, semi-implicit position, Verlet position) for each step.
template <class Look>
void side_by_side(const Spring<double>& spring, double h, long steps, const Look& look) {
    State semi = semi_implicit_euler.step(spring, start, h);
    State before = start, now = semi;  // Verlet begins with the same two positions
    for (long n = 1; n <= steps; ++n) {
        look(n, spring.exact(start, n * h).x, semi.x, now.x);
        semi = semi_implicit_euler.step(spring, semi, h);
        const State next = verlet.step(spring, before, now, h);
        before = now;
        now = next;
    }
}

// In float: the error after two seconds against the step, for plain Verlet and velocity Verlet.
template <class Method>
double float_error(const Method& method, long steps) {
    const float h = 2.0f / float(steps);
    const State end = run(method, Spring(1.0f), State<float>{0, 1, 0}, h, steps);
    return std::fabs(end.x - std::cos(double(h) * double(steps)));
}

void rounding_in_float(lab::Findings& out) {
    auto& table = out.table("floats.tsv", {"step", "verlet", "velocity_verlet"});
    double plain = 0, with_velocity = 0, best = 1, best_step = 1;
    long steps = 0;
    for (int i = 0; i <= 32; ++i) {
        steps = std::lround(8 * std::pow(2.0, i / 2.0));
        plain = float_error(verlet, steps);
        with_velocity = float_error(velocity_verlet, steps);
        table.row({2.0 / steps, plain, with_velocity});
        if (plain < best) best = plain, best_step = 2.0 / steps;
    }
    // 2·1 − 1 − h² rounds back to 1 in float once h² is below half of the distance ε/2 to the next
    // number below.
    const double freezes = std::sqrt(std::numeric_limits<float>::epsilon() / 4);
    const auto moves = [](float h) {
        return verlet.step(Spring(1.0f), State{0, 1.0f, 0.0f}, State{h, 1.0f, 0.0f}, h).x != 1;
    };
    out.number("float_freezes", freezes, "s", "step below which Verlet in float stands still", 2);
    out.check("float_frozen", !moves(float(freezes * 0.99)) && moves(float(freezes * 1.01)),
              "in float, with shorter steps than this, Verlet's mass does not leave its start at all");
    std::printf("  in float, %ld steps of %.1e s: Verlet is %.1e m off,\n  velocity Verlet %.1e m\n", steps,
                2.0 / steps, plain, with_velocity);
    out.number("float_steps", double(steps), "", "steps of the shortest length in float");
    out.number("float_plain", plain, "m", "Verlet's error in float with the shortest step", 2);
    out.number("float_velocity", with_velocity, "m", "velocity Verlet's error there", 2);
    out.number("float_best_step", best_step, "s", "step with Verlet's least error in float", 2);
    out.check("float_worse", plain > 10 * with_velocity && plain > 10 * best,
              "in float and with very short steps plain Verlet is over ten times worse than "
              "velocity Verlet, "
              "and than itself with longer steps");
}

// How far something falls in a second at 60 Hz, from rest at the height x0, in float.
template <class Method>
double fall_in_float(const Method& method, float x0) {
    const State end = run(method, Projectile(-9.81f), State<float>{0, x0, 0}, 1.0f / 60, 60);
    return double(x0) - double(end.x);
}

void far_away_in_float(lab::Findings& out) {
    const double true_fall = 9.81 / 2, frame = 9.81 / 3600;
    const auto last_digit = [](float x) { return double(std::nextafter(x, 2 * x) - x); };
    const double near = fall_in_float(verlet, 5000), far = fall_in_float(verlet, 20000),
                 with_velocity = fall_in_float(velocity_verlet, 20000);
    std::printf(
        "  a second of fall at 60 Hz in float, %.4g m: at 5 km Verlet falls %.3g m,\n"
        "  at 20 km %.3g m, velocity Verlet %.3g m\n",
        true_fall, near, far, with_velocity);
    out.number("fall_true", true_fall, "m", "a second of fall", 4);
    out.number("fall_frame", 1e3 * frame, "mm", "h²g at 60 Hz", 2);
    out.number("fall_digit_near", 1e3 * last_digit(5000), "mm", "the last binary digit of 5 km in float", 2);
    out.number("fall_digit_far", 1e3 * last_digit(20000), "mm", "the last binary digit of 20 km in float", 2);
    out.number("fall_near", near, "m", "a second of fall by Verlet in float, 5 km from the origin", 3);
    out.number("fall_far", far, "m", "the same 20 km from the origin", 3);
    out.number("fall_velocity", with_velocity, "m", "the same by velocity Verlet, 20 km from the origin", 3);
    out.check("fall_in_float",
              std::fabs(near / true_fall - 1) > 0.05 && std::fabs(far / true_fall - 1) > 0.2 &&
                  std::fabs(with_velocity / true_fall - 1) < 0.02,
              "in float, a second of fall by Verlet is off by more than 5 % at 5 km from the origin and "
              "by more than 20 % at 20 km; by velocity Verlet by less than 2 % at 20 km");
}

}  // namespace

void two_positions(const Settings& settings, lab::Findings& out) {
    out.section("Two positions instead of a velocity");
    const Spring spring(settings.omega);
    const double h = settings.step, wh = settings.wh();
    auto& overlay = out.table("overlay.tsv", {"t", "exact", "semi_implicit", "verlet"});
    overlay.row({0.0, 1.0, 1.0, 1.0});
    side_by_side(spring, h, settings.steps, [&](long n, double exact, double semi, double plain) {
        overlay.row({n * h, exact, semi, plain});
    });

    // Roundoff enters x₂ = 2x₁ − x₀ + h²a with at most 2εA + 3ε(ωh)²A a step, A the largest |x|,
    // and grows from there like sin(nθ)/sin θ, a solution of the same formula. Semi-implicit
    // Euler's own roundoff, εA/2 in x and ε h|v| ≤ ε ωh A in the velocity, adds less than as much
    // again. No n of them add up to more than
    const double theta = wh < 2 ? std::acos(1 - wh * wh / 2) : pi / 2;
    const double amplitude = wh < 2 ? 1 / std::sqrt(1 - wh * wh / 4) : 1;
    const double a_step = 2 * (2 + 3 * wh * wh) * eps * amplitude / std::sin(theta);

    const long steps = 100000;
    auto& roundoff = out.table("roundoff.tsv", {"n", "difference", "bound"});
    double worst = 0, shown = 1;
    side_by_side(spring, h, steps, [&](long n, double, double semi, double plain) {
        worst = std::max(worst, std::fabs(plain - semi));
        if (double(n) >= shown && worst > 0) {
            roundoff.row({double(n), worst, a_step * n});
            shown *= 1.1;
        }
    });
    std::printf("  omega = %g rad/s, h = %.5g s (omega h = %.4g)\n", settings.omega, h, wh);
    std::printf("  Verlet and semi-implicit Euler, %ld steps: positions differ by %.1e m at most\n", steps, worst);
    out.number("omega", settings.omega, "rad/s", "angular frequency of the spring");
    out.number("rate", 1 / h, "Hz", "steps a second");
    out.number("wh", wh, "", "angular frequency times step");
    out.number("steps", double(settings.steps), "", "steps in the first picture");
    out.number("identity_steps", double(steps), "", "steps compared");
    out.number("identity_worst", worst, "m", "Verlet against semi-implicit Euler, worst", 2);
    out.check("identity", worst < a_step * steps,
              "plain Verlet steps through the positions of semi-implicit Euler, to the growth of "
              "roundoff");
    rounding_in_float(out);
    far_away_in_float(out);
}
