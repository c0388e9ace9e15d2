// The cheapest step is none: who may sleep, and which methods keep a body awake?

#include <cmath>
#include <cstdio>

#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double h = 1.0 / 60, longest = 60;      // s
constexpr double asleep_below = 0.05 * 0.05 / 2;  // kinetic energy, J/kg: that of 5 cm/s
constexpr double calm_for = 0.5;                  // s

// A body may sleep once it has stayed below the threshold for a while.
/// [rule]
class Drowsy {
public:
    explicit Drowsy(double patience) : patience_(patience) {}

    bool asleep(double energy, double h) {
        const bool calm = energy < asleep_below;
        calm_for_ = calm ? calm_for_ + h : 0;
        return calm_for_ >= patience_;
    }

private:
    double patience_, calm_for_ = 0;  // s
};
/// [rule]

// A lamp on a chain, a damped spring as long as it swings a little, let go at 20 cm.
const double omega = 6, zeta = 0.04, start = 0.2;

// When does it fall asleep? Leaves the fastest that it was in each half second, for the picture.
template <class Next>
double sleeps_after(Next next, double patience, lab::Table* table = nullptr) {
    Drowsy rule(patience);
    State<double> s{0, start, 0};
    double fastest = 0;
    for (int n = 1; n <= int(longest / h); ++n) {
        s = next(s, n);
        fastest = std::fmax(fastest, std::fabs(s.v));
        const bool asleep = rule.asleep(s.v * s.v / 2, h);
        if (table && (n % 31 == 0)) table->row({n * h, fastest}), fastest = 0;
        if (asleep) {
            if (table && fastest > 0) table->row({n * h, fastest});
            return n * h;
        }
    }
    return longest;
}

}  // namespace

void sleeping(lab::Findings& out) {
    out.section("Who may sleep?");
    const DampedSpring lamp(omega, zeta);
    const auto try_one = [&](const std::string& key, const char* name, auto next) {
        const double after = sleeps_after(next, calm_for, &out.table("sleep_" + key + ".tsv", {"t", "fastest"}));
        std::printf("  %-24s %s %.1f s\n", name, after < longest ? "asleep after" : "still awake after", after);
        return after;
    };
    const auto by = [&](const auto& method) {
        return [&](const State<double>& s, int) { return method.step(lamp, s, h); };
    };
    const auto truth = [&](const State<double>&, int n) { return lamp.exact(State<double>{0, start, 0}, n * h); };
    const double exact = try_one("exact", "exact", truth);
    const double expl = try_one("explicit_euler", explicit_euler.name, by(explicit_euler));
    const double impl = try_one("implicit_euler", implicit_euler.name, by(implicit_euler));
    const double semi = try_one("semi_implicit_euler", semi_implicit_euler.name, by(semi_implicit_euler));
    const double constant = try_one("constant_acceleration", "constant acceleration", by(constant_acceleration));
    // The rule on one frame alone: it stands still where it turns round.
    const double hasty = sleeps_after(by(semi_implicit_euler), h);
    const State<double> hung = lamp.exact(State<double>{0, start, 0}, hasty);
    std::printf("  looked at for one frame alone it sleeps after %.2g s, at %.2g of its swing\n", hasty,
                hung.x / start);
    out.number("sleep_omega", omega, "rad/s", "the lamp");
    out.number("sleep_zeta", zeta, "", "its damping ratio");
    out.number("sleep_exact", exact, "s", "when the lamp may sleep, in truth");
    out.number("sleep_implicit", impl, "s", "by implicit Euler");
    out.number("sleep_semi", semi, "s", "by semi-implicit Euler");
    out.number("sleep_constant_acceleration", constant, "s", "by the constant-acceleration step");
    out.number("sleep_watched", longest, "s", "how long we watched explicit Euler");
    out.number("sleep_hasty_at", 100 * std::fabs(hung.x) / start, "%",
               "how far out it stops when one frame decides, of where it was let go", 2);
    out.check("sleep_awake",
              expl == longest && constant > 1.5 * exact && impl < 0.7 * exact && std::fabs(semi / exact - 1) < 0.1,
              "a lamp falls asleep within a tenth of the true time by semi-implicit Euler, by "
              "implicit Euler too early, by the "
              "constant-acceleration step too late, and by explicit Euler not at all");
    out.check("sleep_hasty", std::fabs(hung.x) > 0.8 * start && hasty < 1,
              "where one frame decides, the lamp stops where it turns round for the first time");
}
