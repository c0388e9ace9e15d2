// A cloth of stiff springs: many small steps, or one that solves a large sparse system?

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <deque>
#include <string>
#include <tuple>
#include <vector>

#include "cloth.hpp"
#include "sections.hpp"

namespace {

constexpr double frame = 1.0 / 60;                // s
constexpr double exactly = 1e-6, roughly = 1e-2;  // tolerances of the conjugate gradients

// Processor time, s: whoever shares the machine does not count. Where that is too short to be seen,
// by the clock.
template <class Work>
double seconds_of(const Work& work) {
    const std::clock_t processor = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    work();
    const double clock = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double spent = double(std::clock() - processor) / CLOCKS_PER_SEC;
    return spent > 0 ? spent : clock;
}

double reach(const Cloth& cloth) { return cloth.x().cwiseAbs().maxCoeff(); }
double lowest(const Cloth& cloth) { return cloth.x()(cloth.x().size() - 1); }

// Steps until a mass is ten metres away; `most` if none ever is.
long survives(Cloth cloth, double h, long most) {
    long n = 0;
    while (n < most && reach(cloth) < 10) step_explicit(cloth, h), ++n;
    return n;
}

long substeps(const Cloth& cloth) { return std::lround(std::ceil(frame * cloth.fastest() / 2)); }

// A cloth that has begun to fall and swing, and what one frame costs it.
struct Fallen {
    int n;
    double stiffness;
    Cloth cloth{n, stiffness};
    Factorised factorised{cloth};
    long substeps = ::substeps(cloth);
    int products = 0, few_products = 0;
    // Milliseconds a frame, the least so far.
    double many = INFINITY, factors = INFINITY, gradients = INFINITY, rough = INFINITY;
    double apart = 0;  // two solvers of one step, as a part of the motion

    Fallen(int masses, double k) : n(masses), stiffness(k) {
        for (int i = 0; i < 12; ++i) factorised.step(cloth, frame);
    }
    void measure() {
        Cloth end = cloth, other = cloth;
        const auto least = [](double& ms, const auto& work) { ms = std::min(ms, 1e3 * seconds_of(work)); };
        least(many, [&] {
            for (long i = 0; i < substeps; ++i) step_explicit(end, frame / double(substeps));
        });
        end = cloth;
        least(factors, [&] { factorised.step(end, frame); });
        least(gradients, [&] { products = step_gradients(other, frame, exactly); });
        apart = (end.x() - other.x()).norm() / (end.x() - cloth.x()).norm();
        other = cloth;
        least(rough, [&] { few_products = step_gradients(other, frame, roughly); });
    }
};

std::string words(const char* format, double value) {
    char text[24];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// Who survives: one explicit step a frame, as many as the fastest swing asks for, a tenth fewer;
// and one implicit step at a stiffness that no cloth has.
void survivors(lab::Findings& out) {
    const int n = 12;
    const Cloth cloth(n, 1e4);
    const long enough = substeps(cloth), few = std::lround(0.9 * double(enough));
    const long alone = survives(cloth, frame, 600);
    const long with_enough = survives(cloth, frame / double(enough), 60 * enough);
    const long with_few = survives(cloth, frame / double(few), 60 * few);
    std::printf("  %d x %d masses, 1e4 N/m: the fastest oscillation is %.3g rad/s\n", n, n, cloth.fastest());
    std::printf(
        "  semi-implicit Euler: gone at step %ld with one step a frame, at step %ld with %ld a\n"
        "  frame; with %ld a frame a second passes\n",
        alone, with_few, few, enough);
    double worst = 0;
    for (const double stiffness : {1e4, 1e8}) {
        Cloth stiff(n, stiffness);
        Factorised factorised(stiff);
        for (int i = 0; i < 600; ++i) {
            factorised.step(stiff, frame);
            worst = std::max(worst, std::isfinite(reach(stiff)) ? reach(stiff) : 1e300);
        }
        std::printf("  implicit Euler, one step a frame, %.0e N/m: after 10 s it hangs %.3f m deep\n", stiffness,
                    -lowest(stiff));
    }
    Cloth exact(n, 1e4), rough(n, 1e4);
    for (int i = 0; i < 60; ++i) step_gradients(exact, frame, exactly), step_gradients(rough, frame, roughly);
    double apart = 0;  // the masses' largest distance, cm
    for (int i = 0; i < n * n; ++i) apart = std::max(apart, 100 * (exact.x() - rough.x()).segment<3>(3 * i).norm());
    std::printf("  solved to one percent only, a mass is %.0f cm elsewhere after a second\n", apart);
    out.number("cloth_mass", 144 * cloth.mass(), "kg", "mass of a cloth of 12 x 12");
    out.number("cloth_fastest", cloth.fastest(), "rad/s", "fastest oscillation of a cloth of 12 x 12");
    out.number("cloth_alone", double(alone), "", "steps until it is gone, one explicit step a frame");
    out.number("cloth_enough", double(enough), "", "explicit steps a frame that it needs");
    out.number("cloth_few", double(few), "", "a tenth fewer");
    out.number("cloth_few_gone", double(with_few), "", "steps until it is gone with a tenth fewer");
    out.number("cloth_apart", apart, "cm", "what solving to one percent changes in a second", 2);
    out.check("cloth_explicit_needs",
              alone < 10 && with_few < 60 * few && with_enough == 60 * enough && reach(cloth) < 10,
              "one explicit step a frame blows up, half of h omega does not, a tenth fewer do");
    out.check("cloth_implicit_stands", worst < 1.1,
              "implicit Euler's cloth hangs for ten seconds, at 1e4 and at 1e8 N/m");
    out.check("cloth_rough_stands", apart < 200 && apart > 10 && reach(rough) < 1.1,
              "solved to one percent the cloth stands, and moves otherwise");
}

// Of a cloth without edges, all its waves (a, b), radians from mass to mass: the largest m ω²/k,
// with the springs along n whose ends are a phase φ apart, 2 (1 − cos φ) n nᵀ of each.
double fastest_wave() {
    const double pi = std::acos(-1.0);
    double most = 0;
    for (int i = 0; i <= 64; ++i)
        for (int j = 0; j <= 64; ++j) {
            const double a = pi * i / 32, b = pi * j / 32;
            const auto pull = [](double phase) { return 2 * (1 - std::cos(phase)); };
            const double slanting = (pull(a + b) + pull(a - b)) / 2, mixed = (pull(a + b) - pull(a - b)) / 2;
            const double xx = pull(a) + slanting, yy = pull(b) + slanting;
            most = std::max(most, (xx + yy) / 2 + std::hypot((xx - yy) / 2, mixed));
        }
    return most;
}

void price(lab::Findings& out) {
    std::deque<Fallen> all;  // 24 × 24 at 10⁴ N/m is in both panels, and is measured once
    for (const int n : {8, 12, 16, 24, 32, 40}) all.emplace_back(n, 1e4);
    for (const double stiffness : {1e2, 1e3, 1e5, 1e6}) all.emplace_back(24, stiffness);
    // In turns, and the fastest of all turns counts: what disturbs for a while disturbs all alike.
    for (int turn = 0; turn < 6; ++turn)
        for (Fallen& each : all) each.measure();
    std::vector<const Fallen*> sizes, stiff;
    for (const Fallen& each : all) {
        if (each.stiffness == 1e4) sizes.push_back(&each);
        if (each.n == 24) stiff.push_back(&each);
    }
    std::sort(stiff.begin(), stiff.end(), [](auto* a, auto* b) { return a->stiffness < b->stiffness; });

    std::printf(
        "  one frame, ms:            explicit   implicit Euler\n"
        "  masses   N/m  steps            factorised  gradients to 1e-6  to 1e-2\n");
    double apart = 0;
    bool dear = true;  // a product costs about what an explicit step costs
    for (const Fallen& c : all) {
        std::printf("  %2d x %-2d %6.0e %6ld %8.2f %9.2f %9.2f (%4d) %9.2f (%3d)\n", c.n, c.n, c.stiffness, c.substeps,
                    c.many, c.factors, c.gradients, c.products, c.rough, c.few_products);
        apart = std::max(apart, c.apart);
        dear = dear && c.products > 2 * c.substeps;
    }
    for (const auto& [file, first, cloths] :
         {std::tuple("cloth_sizes.tsv", "n", &sizes), std::tuple("cloth_stiffness.tsv", "stiffness", &stiff)}) {
        auto& table = out.table(file, {first, "explicit", "factorised", "gradients", "rough"});
        for (const Fallen* c : *cloths)
            table.row({cloths == &sizes ? double(c->n) : c->stiffness, c->many, c->factors, c->gradients, c->rough});
    }

    auto& table = out.table("cloth_costs.tsv", {"stiffness, N/m", "explicit steps a frame", "explicit, ms",
                                                "factorised", "gradients to 10⁻⁶", "to 10⁻²"});
    const char* const names[] = {"10²", "10³", "10⁴", "10⁵", "10⁶"};
    for (std::size_t i = 0; i < stiff.size(); ++i) {
        const Fallen& c = *stiff[i];
        table.row({std::string(names[i]), double(c.substeps), words("%.2f", c.many), times(c.factors / c.many),
                   times(c.gradients / c.many), times(c.rough / c.many)});
    }
    // Where the two cost the same, between two of these cloths: straight lines in logarithms.
    double crossing = 0;
    for (std::size_t i = 1; i < stiff.size(); ++i) {
        const double before = std::log(stiff[i - 1]->factors / stiff[i - 1]->many);
        const double after = std::log(stiff[i]->factors / stiff[i]->many);
        if (before > 0 && after <= 0)
            crossing = double(stiff[i - 1]->substeps) *
                       std::pow(double(stiff[i]->substeps) / double(stiff[i - 1]->substeps), before / (before - after));
    }
    const Fallen &soft = *stiff.front(), &usual = *stiff[2], &hard = *stiff.back();
    const double digit = crossing > 0 ? std::pow(10, std::floor(std::log10(crossing))) : 1;
    out.text("cloth_crossing",
             crossing > 0               ? "up to some " + words("%.0f", digit * std::round(crossing / digit))
             : hard.many < hard.factors ? "up to " + std::to_string(hard.substeps) + " and more"
                                        : "below " + std::to_string(soft.substeps) + ", if ever,",
             "explicit steps a frame that are cheaper than factorising, to one digit");
    const auto rough_wins = [](const Fallen* c) { return c->rough < std::min(c->many, c->factors); };
    auto from = stiff.end();  // and so on for all that are stiffer
    while (from != stiff.begin() && rough_wins(*(from - 1))) --from;
    const auto first = from - stiff.begin();
    out.text("cloth_rough_from", first < 5 ? names[first] + std::string(" N/m") : "beyond 10⁶ N/m",
             "the softest of these cloths from which on gradients to one percent are the cheapest");
    out.number("cloth_usual_steps", double(usual.substeps), "", "explicit steps a frame, 24 x 24, 1e4 N/m");
    out.number("cloth_usual_ratio", usual.factors / usual.many, "", "factorised over explicit, 1e4 N/m", 2);
    out.number("cloth_hard_steps", double(hard.substeps), "", "explicit steps a frame, 24 x 24, 1e6 N/m");
    out.number("cloth_hard_ratio", hard.factors / hard.many, "", "factorised over explicit, 1e6 N/m", 2);
    out.number("cloth_soft_products", double(soft.products), "", "products of the gradients, 1e2 N/m");
    out.number("cloth_hard_products", double(hard.products), "", "products of the gradients, 1e6 N/m");
    out.number("cloth_hard_few", double(hard.few_products), "", "the same, to one percent");
    bool same = true;
    for (const Fallen* c : stiff) same = same && c->factorised.size() == usual.factorised.size();
    out.check("cloth_same_work", same, "factorising computes as many numbers, however stiff the cloth");
    const double wave = fastest_wave();
    out.check("cloth_stripes", std::fabs(wave - 8) < 1e-12,
              "of 64 x 64 waves of the cloth none is faster than 8 k/m, the stripes");
    // Both solve one system. What is left of the right side, 1e-6 of it, may stand for a thousand
    // times as much of the motion: the matrix has eigenvalues from m to m + 8 h² k.
    out.check("cloth_solvers_agree", apart < 1e-2, "factors and conjugate gradients give the same step");
    out.check("cloth_gradients_dear", dear,
              "conjugate gradients to 1e-6 take more than twice as many products as explicit steps");
    out.check("cloth_products_grow", hard.products > 10 * soft.products && hard.few_products < hard.products / 10,
              "the stiffer the cloth, the more products the gradients take, to one percent far fewer");
}

// Two moments, seen from the side and above.
void picture(lab::Findings& out) {
    const int n = 20;
    Cloth cloth(n, 1e4);
    Factorised factorised(cloth);
    int done = 0;
    for (const int moment : {24, 300}) {
        for (; done < moment; ++done) factorised.step(cloth, frame);
        auto& table = out.table("cloth_" + std::to_string(moment) + ".tsv", {"x", "y"});
        for (const auto& link : cloth.links()) {
            if (link.length > 1.1 / (n - 1)) continue;  // the slanted ones
            for (const int i : {link.a, link.b}) {
                const Cloth::Vector3 p = cloth.x().segment<3>(3 * i);
                table.row({p(0) + 0.35 * p(1), p(2) + 0.3 * p(1)});
            }
            table.gap();
        }
    }
    out.number("cloth_first", 24 * frame, "s", "time of the first picture");
    out.number("cloth_second", 300 * frame, "s", "time of the second picture");
}

}  // namespace

void cloth(const Settings&, lab::Findings& out) {
    out.section("A cloth of stiff springs");
    survivors(out);
    price(out);
    picture(out);
}
