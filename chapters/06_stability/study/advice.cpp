// What `./course advise` says of every method, and how often it is right.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "advise.hpp"
#include "advise_body.hpp"

#include "sections.hpp"
#include "simulate.hpp"

using namespace timestep;

namespace {

struct Tally {
    long stable = 0, growing = 0, close = 0, right = 0, wrong = 0;
    long near = 0;  // within 10 % of a boundary
};

class Scenes {
public:
    explicit Scenes(unsigned seed) : random_(seed) {}

    double even(double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>()(random_);
    }
    double even_in_log(double low, double high) { return low * std::pow(high / low, even(0, 1)); }

    // One scene for one method. Those without a boundary make up a quarter of all, so of the others
    // two in three are put within 10 % of theirs. Below ωh = 0.02 no run of this length shows a
    // slow growth.
    void spring(const OnSprings& method, bool near, Tally& tally) {
        const bool damped = method.damped.takes_force();
        const double zeta = damped && even(0, 1) > 0.1 ? even_in_log(0.01, 10) : 0;
        const double omega = even_in_log(0.1, 1e5);
        const double limit = method.limit(zeta);
        const bool has_boundary = limit > 0 && std::isfinite(limit);
        const double s = near && has_boundary ? limit * even(0.9, 1.1) : even_in_log(0.02, 10);
        const double h = s / omega;
        const Verdict said = verdict(s, limit);
        tally.near += has_boundary && std::fabs(s / limit - 1) <= 0.1;
        const bool grew = damped ? grows(method.damped, DampedSpring<double>(omega, zeta), omega, h)
                                 : grows(method.spring, Spring<double>(omega), omega, h);
        count(said, grew, tally);
        if (said == (grew ? Verdict::stable : Verdict::grows))
            std::printf("  missed: %s, zeta = %g, omega h = %.6g of %.6g\n", method.name, zeta, s, limit);
    }

    static void count(Verdict said, bool grew, Tally& tally) {
        tally.stable += said == Verdict::stable;
        tally.growing += said == Verdict::grows;
        tally.close += said == Verdict::too_close_to_call;
        tally.right += said == (grew ? Verdict::grows : Verdict::stable);
        tally.wrong += said == (grew ? Verdict::stable : Verdict::grows);
    }

    PrincipalInertia<double> body() {
        const auto reach = [&] { return even_in_log(1e-3, 1); };
        const double A = reach(), B = reach(), C = reach();
        return {B + C, C + A, A + B};
    }
    Vector3<double> direction() {
        std::normal_distribution<double> normal;
        return Vector3<double>(normal(random_), normal(random_), normal(random_)).normalized();
    }

private:
    std::mt19937_64 random_;
};

// Can one step raise the energy of a body at this rate of spin? A thousand directions are tried,
// and the one that the advice itself names.
bool gains(const BodySolver& solver, const PrincipalInertia<double>& inertia, double spin, double h,
           const Vector3<double>& named, Scenes& scenes) {
    double most = named.isZero() ? 1 : solver.gain(inertia, Vector3<double>(h * named));
    for (int i = 0; i < 1000 && !(most > 1 + 1e-12); ++i)
        most = std::max(most, solver.gain(inertia, Vector3<double>(h * spin * scenes.direction())));
    return !(most <= 1 + 1e-12);
}

// The advice for one body, and what the trials say.
void spinning(const BodySolver& solver, const PrincipalInertia<double>& inertia, double spin, double h, Scenes& scenes,
              Tally& tally) {
    const BodyAdvice advised = solver.judge(inertia, spin, h, true);
    const Verdict said = advised.adds == AddsEnergy::never          ? Verdict::stable
                         : advised.adds == AddsEnergy::one_step_can ? Verdict::grows
                                                                    : Verdict::too_close_to_call;
    Scenes::count(said, gains(solver, inertia, spin, h, advised.worst_spin, scenes), tally);
}

void add(lab::Table& table, const std::string& what, const Tally& tally) {
    table.row({what, double(tally.stable), double(tally.growing), double(tally.close), double(tally.right),
               double(tally.wrong)});
    std::printf("  %-34s %6ld %6ld %6ld %6ld %6ld\n", what.c_str(), tally.stable, tally.growing, tally.close,
                tally.right, tally.wrong);
}

Tally total_of(const std::vector<Tally>& tallies) {
    Tally total;
    for (const Tally& t : tallies) {
        total.stable += t.stable, total.growing += t.growing, total.close += t.close;
        total.right += t.right, total.wrong += t.wrong, total.near += t.near;
    }
    return total;
}

// A share in percent, two digits, as the command has it.
std::string percent(double share) {
    const double digit = std::pow(10, std::floor(std::log10(100 * share)) - 1);
    char text[32];
    std::snprintf(text, sizeof text, share < 0.995 ? "%.2g %%" : "%.0f %%",
                  share < 0.995 ? 100 * share : digit * std::round(100 * share / digit));
    return text;
}

// What the recommended method costs, in whole substeps, over the cheapest one that would have been
// as near at steps of any length: at random springs and steps, to one percent.
void recommended(lab::Findings& out) {
    Scenes scenes(18);
    std::vector<double> dearer;
    for (int i = 0; i < 300; ++i) {
        const DampedSpring<double> spring(1, scenes.even(0, 1) < 0.25 ? 0 : scenes.even_in_log(0.01, 30));
        const double h = scenes.even_in_log(0.05, 1e4);
        const auto all = advise(spring, h);
        const Recommendation answer = recommend(spring, h, {.precise = true}, all);
        for (const Advice& each : all)
            if (each.method == answer.method && answer.substeps > 0)
                dearer.push_back(each.cost * double(answer.substeps) / best_cost(*cheapest(all, h), h));
    }
    std::sort(dearer.begin(), dearer.end());
    const double worst = dearer.back(), half = dearer[dearer.size() / 2];
    std::printf(
        "  recommended to one percent, over the cheapest that is: × %.3g in the middle, × %.3g at "
        "worst\n",
        half, worst);
    out.number("recommended_usual", half, "",
               "cost of the recommended method over the cheapest as near, in the middle of 300 springs", 2);
    out.check("recommended", dearer.size() == 300 && half < 1.2 && worst < 2,
              "to one percent the recommended method, in whole substeps, costs less than twice "
              "what the cheapest would at steps of "
              "any length, and in half of the springs less than 1.2 times");
}

}  // namespace

// What the advice is for the spring of the options.
void your_spring(const Settings& settings, lab::Findings& out) {
    const DampedSpring<double> spring(settings.omega, settings.zeta);
    const auto all = advise(spring, settings.step);  // refuses before anything is printed
    out.section("Your spring");
    auto& table = out.table("your_spring.tsv", {"method", "verdict", "off by", "a second later", "why"});
    std::printf("  omega = %g rad/s, zeta = %g, h = %.4g s, omega h = %.4g\n", settings.omega, settings.zeta,
                settings.step, settings.omega * settings.step);
    // Of the true motion the slower part is left in the long run: e^(−ζωt), or the slow one of two
    // decays.
    const double zeta = settings.zeta;
    const double slow = zeta < 1 ? zeta : 1 / (zeta + std::sqrt(zeta * zeta - 1));
    table.row({"the true motion", "", "", times(std::exp(-slow * settings.omega)), ""});
    for (const Advice& advice : all) {
        const bool told = std::isfinite(advice.growth_per_second);
        const std::string growth = told ? times(advice.growth_per_second) : "–";
        const std::string verdict = told_verdict(advice);
        // Of a limit that is the root of a long equation the number is enough.
        const std::string off = told ? percent(advice.position_error) : "–";
        table.row({advice.method, verdict, off, growth, advice.reason.substr(0, advice.reason.find(", the "))});
        std::printf("  %-34s %-18s %s\n", advice.method.c_str(), verdict.c_str(), growth.c_str());
    }
    recommended(out);
    if (const Advice* best = cheapest(all, settings.step)) {
        out.text("cheapest", best->method,
                 "the cheapest method whose positions are right to one percent in the first period");
        out.number("cheapest_rate", 1 / best_step(*best, settings.step), "Hz", "the steps a second that it takes");
    }
}

void advice(const Settings&, lab::Findings& out) {
    out.section("Ten thousand scenes");
    std::printf("  %-34s %6s %6s %6s %6s %6s\n", "verdicts and what the simulation says", "stable", "grows", "close",
                "right", "wrong");
    auto& table = out.table("advice.tsv", {"scenes of", "stable", "grows", "too close to call", "right", "wrong"});
    Scenes scenes(6);
    std::vector<Tally> tallies;

    const auto springs = [&](const OnSprings& method) {
        Tally tally;
        for (int i = 0; i < 738; ++i) scenes.spring(method, i % 3 != 0, tally);
        add(table, method.name, tally);
        tallies.push_back(tally);
    };
    for_all_methods(springs);

    // Spinning bodies: the talk's iteration near its boundary, every solver elsewhere.
    Tally bodies;
    for (int i = 0; i < 406; ++i) {
        const auto inertia = scenes.body();
        const double spin = scenes.even_in_log(0.1, 100);
        const double size = scenes.even_in_log(0.01, 10);
        if (i % 2 == 0) {
            const double limit = longest_safe_step(inertia, spin);
            const double h = limit * scenes.even(0.9, 1.1);
            ++bodies.near;
            spinning(body_solver(ImplicitGyroscopic::name), inertia, spin, h, scenes, bodies);
        } else {
            spinning(body_solvers()[std::size_t(i / 2 % 6)], inertia, spin, size / spin, scenes, bodies);
        }
    }
    add(table, "spinning bodies", bodies);
    tallies.push_back(bodies);
    const Tally total = total_of(tallies);
    add(table, "all", total);

    const double all = double(total.stable + total.growing + total.close);
    const double decided = double(total.right + total.wrong);
    out.number("scenes", all, "", "random scenes");
    out.number("right_share", 100 * total.right / decided, "%", "verdicts that the simulation confirms", 5);
    char share[32];
    std::snprintf(share, sizeof share, "%.2f %%", 100 * total.right / decided);
    out.text("right_words", total.wrong == 0 ? "all" : share, "verdicts that the simulation confirms");
    out.number("near_share", 100 * total.near / all, "%", "scenes within 10 % of a boundary", 2);
    std::printf("  %ld of them within 10 %% of a boundary\n", total.near);
    out.number("close_share", 100 * total.close / all, "%", "scenes too close to call", 2);
    out.check("advice_right", total.right >= 0.999 * decided && total.close <= 0.01 * all && total.near >= 0.5 * all,
              "at least 99.9 % of the verdicts are right, and at most 1 % of the scenes too close to "
              "call, where "
              "half of them are within 10 % of a boundary");
}
