// How fast Runge-Kutta 4 loses energy, and up to which spin that does not matter.

#include <cmath>
#include <cstdio>

#include <timestep/measured_order.hpp>

#include "random_body.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

// The share of the energy that a minute takes.
double lost_in_a_minute(const Body& inertia, const Vector& spin, double h) {
    const Steps steps = method("runge_kutta_4").made(inertia);
    const Spin start = spinning(spin), end = steps(start, h, std::lround(60 / h));
    return 1 - kinetic_energy(inertia, end.omega) / kinetic_energy(inertia, start.omega);
}

}  // namespace

void runge_kutta(const Settings&, lab::Findings& out) {
    out.section("Runge-Kutta 4: the energy");
    const Body bodies[] = {{1, 1.02, 0.7}, box(12.0, 1.0, 2.0, 3.0), {1, 1.01, 0.02}, box(0.05, 1.0, 0.1, 0.02)};
    const double h = 1.0 / 60, calm = 0.3;  // h|ω|
    const int throws = 300;
    double worst = 0;
    bool fifth = true;
    for (const Body& inertia : bodies) {
        std::vector<double> steps, losses;
        for (const double step : {h, h / 2, h / 4}) {
            steps.push_back(step);
            losses.push_back(lost_in_a_minute(inertia, 10.0 / 3 * Vector(1, 2, 2), step));
        }
        const double power = measured_order(steps, losses);
        fifth = fifth && std::fabs(power - 5) < 0.1;
        double loss = 0;  // a needle loses ten times as much if it is thrown the worst way
        RandomBody random(11);
        for (int n = 0; n < throws; ++n)
            loss = std::max(loss, lost_in_a_minute(inertia, calm / h * random.direction(), h));
        worst = std::max(worst, loss);
        std::printf("  loss with h to the power of %.2f; at h|omega| = %.1f at most %.2g %%\n", power, calm,
                    100 * loss);
    }
    out.number("rk4_calm", calm, "", "h|omega| at which Runge-Kutta 4 was watched for a minute");
    out.number("rk4_calm_spin", calm / h, "rad/s", "the spin that this is at 60 Hz");
    out.number("rk4_calm_loss", 100 * worst, "%", "of the energy that a minute takes at most", 2);
    out.check("rk4_fifth", fifth, "Runge-Kutta 4 loses energy with the fifth power of h");
    out.check("rk4_calm", worst > 0.01 && worst < 0.05,
              "at h|ω| = 0.3 Runge-Kutta 4 loses more than 1 % and less than 5 % of the energy in "
              "a minute, in the worst throw");
}
