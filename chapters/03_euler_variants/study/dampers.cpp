// Several dampers at the new velocity: one after another, there and back, or all in one matrix.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <timestep/damper_sweep.hpp>
#include <timestep/models/damped_spring.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using Numbers = std::vector<double>;

double product(const Numbers& a, const Numbers& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}
void add(Numbers& a, double factor, const Numbers& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

// A spring or damper pulls along a direction g of all the velocities u = √m v: n/√m at one mass,
// −n/√m at the other.
struct Pull {
    Numbers g;
    double strength;  // N/m of a spring, N s/m of a damper
};
struct Masses {
    std::vector<Pull> springs, dampers;
    double h;
};

// What is left of the velocities u by one damper: the division by 1 + hc g·g along g, or its square
// root.
void divide(const Pull& damper, double h, Numbers& u) {
    const double c = h * damper.strength;
    add(u, -c / (1 + c * product(damper.g, damper.g)) * product(damper.g, u), damper.g);
}
void divide_by_root(const Pull& damper, double h, Numbers& u) {
    const double gg = product(damper.g, damper.g), s = h * damper.strength * gg;
    add(u, -(1 - 1 / std::sqrt(1 + s)) / gg * product(damper.g, u), damper.g);
}

void one_way(const Masses& all, Numbers& u) {
    for (const Pull& damper : all.dampers) divide(damper, all.h, u);
}
void there_and_back(const Masses& all, Numbers& u) {
    for (auto damper = all.dampers.begin(); damper != all.dampers.end(); ++damper) divide_by_root(*damper, all.h, u);
    for (auto damper = all.dampers.rbegin(); damper != all.dampers.rend(); ++damper) divide_by_root(*damper, all.h, u);
}
// (1 + h Σ c g gᵀ) u₂ = u₁, by Gauss's elimination: the matrix is symmetric and positive, so it
// needs no pivot.
void one_matrix(const Masses& all, Numbers& u) {
    const std::size_t n = u.size();
    std::vector<Numbers> a(n, Numbers(n));
    for (std::size_t i = 0; i < n; ++i) {
        a[i][i] = 1;
        for (const Pull& damper : all.dampers) add(a[i], all.h * damper.strength * damper.g[i], damper.g);
    }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = k + 1; i < n; ++i) {
            const double share = a[i][k] / a[k][k];
            add(a[i], -share, a[k]);
            u[i] -= share * u[k];
        }
    for (std::size_t k = n; k-- > 0;) {
        u[k] /= a[k][k];
        for (std::size_t i = 0; i < k; ++i) u[i] -= a[i][k] * u[k];
    }
}

using Damp = void (*)(const Masses&, Numbers&);

// The energy after each step, over that of the start, at rest at y = √m x. Semi-implicit Euler:
// springs, dampers, positions.
Numbers energies(const Masses& all, Damp damp, Numbers y, long steps) {
    Numbers u(y.size()), result;
    const auto energy = [&] {
        double twice = product(u, u);
        for (const Pull& spring : all.springs) twice += spring.strength * std::pow(product(spring.g, y), 2);
        return twice / 2;
    };
    const double first = energy();
    for (long n = 0; n < steps; ++n) {
        for (const Pull& spring : all.springs) add(u, -all.h * spring.strength * product(spring.g, y), spring.g);
        damp(all, u);
        add(y, all.h, u);
        result.push_back(energy() / first);
    }
    return result;
}

// A mass of 1 kg on a spring along x with ωh = 1, and two dampers at ± so many degrees to it.
constexpr double hertz = 60, omega = hertz;
Masses crossed(double degrees, double c) {
    const double angle = degrees * pi / 180;
    return {{{{1, 0}, omega * omega}},
            {{{std::cos(angle), std::sin(angle)}, c}, {{std::cos(angle), -std::sin(angle)}, c}},
            1 / hertz};
}

// Masses in a row from a wall, a spring and a damper before each.
Masses row(std::size_t count, double mass, double stiffness, double c) {
    Masses all{{}, {}, 1 / hertz};
    for (std::size_t i = 0; i < count; ++i) {
        Numbers g(count);
        g[i] = 1 / std::sqrt(mass);
        if (i > 0) g[i - 1] = -g[i];
        all.springs.push_back({g, stiffness}), all.dampers.push_back({g, c});
    }
    return all;
}

}  // namespace

void dampers(const Settings&, lab::Findings& out) {
    out.section("Several dampers");
    const double degrees = 20, c = 200;
    const Masses cross = crossed(degrees, c);
    const long second = std::lround(hertz);
    const Numbers pulled{1, 0};
    const Numbers once = energies(cross, one_way, pulled, second),
                  back = energies(cross, there_and_back, pulled, second),
                  matrix = energies(cross, one_matrix, pulled, second);
    // Along x the two dampers are one of 2c cos²; across, they pull against each other and cancel.
    const double along = std::cos(degrees * pi / 180);
    const DampedSpring exact(omega, 2 * c * along * along / (2 * omega));
    const State start{0, 1.0, 0.0};
    auto& table = out.table("dampers.tsv", {"t", "exact", "one_way", "there_and_back", "one_matrix"});
    table.row({0.0, 1.0, 1.0, 1.0, 1.0});
    for (long n = 0; n < second; ++n) {
        const double t = double(n + 1) / hertz;
        const State s = exact.exact(start, t);
        table.row({t, Spring(omega).energy(s) / Spring(omega).energy(start), once[std::size_t(n)], back[std::size_t(n)],
                   matrix[std::size_t(n)]});
    }
    std::printf(
        "  1 kg, omega h = 1, two dampers of %g N s/m at +-%g degrees, after 1 s: energy times "
        "%.3g one way,\n"
        "  %.3g there and back, %.3g in one matrix\n",
        c, degrees, once.back(), back.back(), matrix.back());
    out.number("dampers_degrees", degrees, "°", "two dampers at this angle to the spring");
    out.number("dampers_c", c, "N s/m", "each of them");
    out.number("dampers_once", once.back(), "", "energy after 1 s over that of the start, one after another", 2);
    out.check("dampers_one_way_grows", once.back() > 50,
              "two hard dampers at 20 degrees to a spring with omega h = 1, one after another, "
              "multiply its energy by over 50 in 1 s");
    const auto falls = [](const Numbers& e) { return *std::max_element(e.begin(), e.end()) < 1 && e.back() < 1e-4; };
    out.check("dampers_cured", falls(back) && falls(matrix),
              "the same two dampers there and back, or in one matrix, leave less than a "
              "ten-thousandth of the energy after 1 s, "
              "and never more than there was");

    // From which damping on does it grow? 20,000 steps tell a growth of 0.0004 a step from none.
    double low = 0.1, high = 10;
    for (int i = 0; i < 20; ++i) {
        const double zeta = (low + high) / 2;
        const double last = energies(crossed(10, 2 * zeta * omega), one_way, pulled, 20000).back();
        (last < 1e6 ? low : high) = zeta;
    }
    std::printf("  at +-10 degrees one way grows from zeta = %.3f of each damper\n", low);
    out.number("dampers_onset", low, "",
               "the damping ratio of each from which two dampers at 10 degrees blow up, one way", 2);
    out.check("dampers_onset", low > 1.05 && low < 1.08,
              "two dampers at 10 degrees to a spring with omega h = 1, one after another, grow "
              "from a zeta of 1.05 to 1.08 each");

    // Twenty masses in a row, of 2 kg on 400 N/m: ωh = 0.47. The last one is pulled out.
    const std::size_t count = 20;
    const double mass = 2, stiffness = 400, hard = 1000, seconds = 3;
    const Masses chain = row(count, mass, stiffness, hard);
    Numbers end(count);
    end.back() = 1;
    const long steps = std::lround(seconds * hertz);
    const double chain_once = energies(chain, one_way, end, steps).back();
    const double chain_matrix = energies(chain, one_matrix, end, steps).back();
    // There and back by the library; mass 0 is the wall.
    Numbers inverse(count + 1, 1 / mass);
    inverse[0] = 0;
    DamperSweep<double> sweep(inverse);
    for (std::size_t i = 0; i < count; ++i) sweep.add(i, i + 1, 1.0, hard);
    Numbers x(count + 1), v(count + 1);
    x.back() = 1 / std::sqrt(mass);
    for (long n = 0; n < steps; ++n) {
        for (std::size_t i = 0; i < count; ++i) {
            const double pull = stiffness * (x[i + 1] - x[i]) * chain.h / mass;
            v[i] += i > 0 ? pull : 0, v[i + 1] -= pull;
        }
        sweep.there_and_back(v, chain.h);
        add(x, chain.h, v);
    }
    double chain_back = mass * product(v, v);
    for (std::size_t i = 0; i < count; ++i) chain_back += stiffness * std::pow(x[i + 1] - x[i], 2);
    chain_back /= stiffness / mass;  // twice the energy of the start
    const double by_rows = energies(chain, there_and_back, end, steps).back();
    std::printf(
        "  a row of %zu masses, dampers of %g N s/m, after %g s: energy times %.3g one way, %.3g "
        "there and back\n"
        "  (the library's sweep; by rows %.3g), %.3g in one matrix\n",
        count, hard, seconds, chain_once, chain_back, by_rows, chain_matrix);
    out.number("dampers_masses", double(count), "", "masses in a row");
    out.number("dampers_chain_once", chain_once / 1e6, "",
               "millions: its energy after 3 s over that of the start, one way", 2);
    out.number("dampers_chain_back", 100 * chain_back, "%", "there and back", 2);
    out.number("dampers_chain_matrix", 100 * chain_matrix, "%", "in one matrix", 2);
    out.check("dampers_chain", chain_once > 1e6 && chain_back < 1 && chain_matrix < 1,
              "a row of twenty hard-damped masses, damper after damper from the wall, has over a "
              "million times its energy after "
              "3 s; there and back or in one matrix less than at the start");
    out.check("dampers_library", std::fabs(chain_back / by_rows - 1) < 1e-9,
              "the library's sweep and this study's agree in that row");
    out.check("dampers_inaccurate", chain_back < chain_matrix / 2 || chain_back > 2 * chain_matrix,
              "in that row there and back is off by more than a factor of two from one matrix: "
              "stable, not accurate");
}
