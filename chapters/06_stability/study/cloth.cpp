// A cloth of stiff springs: many small steps, or one that solves a large sparse system?

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "cloth.hpp"
#include "sections.hpp"
#include "timing.hpp"

namespace {

constexpr double frame = 1.0 / 60;                // s
constexpr double exactly = 1e-6, roughly = 1e-2;  // tolerances of the conjugate gradients

// The least of a few goes: others share the machine.
template <class Work>
double milliseconds(int goes, const Work& work) {
    return 1e3 * lab::fastest(goes, work);
}

double reach(const Cloth& cloth) {
    return cloth.x().cwiseAbs().maxCoeff();
}
double lowest(const Cloth& cloth) {
    return cloth.x()(cloth.x().size() - 1);
}

// Steps until a mass is ten metres away; `most` if none ever is.
long survives(Cloth cloth, double h, long most) {
    long n = 0;
    while (n < most && reach(cloth) < 10) step_explicit(cloth, h), ++n;
    return n;
}

long substeps(const Cloth& cloth) {
    return std::lround(std::ceil(frame * cloth.fastest() / 2));
}

struct Costs {
    long substeps;
    int products, few_products;
    double many, factors, gradients, rough;  // ms a frame
    double apart;                            // two solvers of one step, as a part of the motion
};

// What one frame costs a cloth that has begun to fall and swing.
Costs costs(int n, double stiffness) {
    Cloth cloth(n, stiffness);
    Factorised factorised(cloth);
    for (int i = 0; i < 12; ++i) factorised.step(cloth, frame);
    Costs c{substeps(cloth), 0, 0, 0, 0, 0, 0, 0};
    Cloth end = cloth, other = cloth;
    c.many = milliseconds(2, [&] {
        end = cloth;
        for (long i = 0; i < c.substeps; ++i) step_explicit(end, frame / double(c.substeps));
    });
    c.factors = milliseconds(3, [&] { end = cloth, factorised.step(end, frame); });
    c.gradients =
        milliseconds(1, [&] { other = cloth, c.products = step_gradients(other, frame, exactly); });
    c.apart = (end.x() - other.x()).norm() / (end.x() - cloth.x()).norm();
    c.rough = milliseconds(
        3, [&] { other = cloth, c.few_products = step_gradients(other, frame, roughly); });
    return c;
}

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
    std::printf("  %d x %d masses, 1e4 N/m: the fastest oscillation is %.3g rad/s\n", n, n,
                cloth.fastest());
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
        std::printf(
            "  implicit Euler, one step a frame, %.0e N/m: after 10 s it hangs %.3f m deep\n",
            stiffness, -lowest(stiff));
    }
    Cloth exact(n, 1e4), rough(n, 1e4);
    for (int i = 0; i < 60; ++i)
        step_gradients(exact, frame, exactly), step_gradients(rough, frame, roughly);
    double apart = 0;  // the masses' largest distance, cm
    for (int i = 0; i < n * n; ++i)
        apart = std::max(apart, 100 * (exact.x() - rough.x()).segment<3>(3 * i).norm());
    std::printf("  solved to one percent only, a mass is %.0f cm elsewhere after a second\n",
                apart);
    out.number("cloth_mass", 144 * cloth.mass(), "kg", "mass of a cloth of 12 x 12");
    out.number("cloth_fastest", cloth.fastest(), "rad/s", "fastest oscillation of a cloth of 12 x 12");
    out.number("cloth_alone", double(alone), "",
               "steps until it is gone, one explicit step a frame");
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

void cost_over(const char* file, const char* first, lab::Findings& out,
               const std::vector<std::pair<int, double>>& cloths, std::vector<Costs>& all) {
    auto& table = out.table(file, {first, "substeps", "explicit", "factorised", "gradients",
                                   "rough", "products", "few_products"});
    for (const auto& [n, stiffness] : cloths) {
        const Costs c = costs(n, stiffness);
        all.push_back(c);
        std::printf("  %2d x %-2d %6.0e %6ld %8.2f %9.2f %9.2f (%4d) %9.2f (%3d)\n", n, n,
                    stiffness, c.substeps, c.many, c.factors, c.gradients, c.products, c.rough,
                    c.few_products);
        table.row({std::string(first) == "n" ? double(n) : stiffness, double(c.substeps), c.many,
                   c.factors, c.gradients, c.rough, double(c.products), double(c.few_products)});
    }
}

void price(lab::Findings& out) {
    std::printf(
        "  one frame, ms:            explicit   implicit Euler\n"
        "  masses   N/m  steps            factorised  gradients to 1e-6  to 1e-2\n");
    std::vector<Costs> sizes, stiff;
    cost_over("cloth_sizes.tsv", "n", out,
              {{8, 1e4}, {12, 1e4}, {16, 1e4}, {24, 1e4}, {32, 1e4}, {40, 1e4}}, sizes);
    cost_over("cloth_stiffness.tsv", "stiffness", out,
              {{24, 1e2}, {24, 1e3}, {24, 1e4}, {24, 1e5}, {24, 1e6}}, stiff);
    double apart = 0;
    for (const auto& c : sizes) apart = std::max(apart, c.apart);
    for (const auto& c : stiff) apart = std::max(apart, c.apart);

    auto& table =
        out.table("cloth_costs.tsv", {"stiffness, N/m", "explicit steps a frame", "explicit, ms",
                                      "factorised", "gradients to 10⁻⁶", "to 10⁻²"});
    const char* const names[] = {"10²", "10³", "10⁴", "10⁵", "10⁶"};
    for (std::size_t i = 0; i < stiff.size(); ++i) {
        const Costs& c = stiff[i];
        const double unit = std::max(c.many, 1e-3);
        table.row({std::string(names[i]), double(c.substeps), words("%.2f", c.many),
                   times(c.factors / unit), times(c.gradients / unit), times(c.rough / unit)});
    }
    // Where the two cost the same, between two of these cloths: straight lines in logarithms.
    double crossing = 0;
    for (std::size_t i = 1; i < stiff.size(); ++i) {
        const double before = std::log(stiff[i - 1].factors / stiff[i - 1].many);
        const double after = std::log(stiff[i].factors / stiff[i].many);
        if (before > 0 && after <= 0)
            crossing = double(stiff[i - 1].substeps) *
                       std::pow(double(stiff[i].substeps) / double(stiff[i - 1].substeps),
                                before / (before - after));
    }
    const double digit = crossing > 0 ? std::pow(10, std::floor(std::log10(crossing))) : 1;
    out.number("cloth_crossing", digit * std::round(crossing / digit), "",
               "explicit steps a frame that cost what factorising costs, to one digit");
    const auto rough_wins = [](const Costs& c) { return c.rough < std::min(c.many, c.factors); };
    const auto first = std::find_if(stiff.begin(), stiff.end(), rough_wins) - stiff.begin();
    out.text("cloth_rough_from", first < 5 ? names[first] + std::string(" N/m") : "beyond 10⁶ N/m",
             "the softest of these cloths for which gradients to one percent are the cheapest");
    const Costs &soft = stiff.front(), &usual = stiff[2], &hard = stiff.back();
    out.number("cloth_usual_steps", double(usual.substeps), "",
               "explicit steps a frame, 24 x 24, 1e4 N/m");
    out.number("cloth_usual_ratio", usual.factors / usual.many, "",
               "factorised over explicit, 1e4 N/m", 2);
    out.number("cloth_hard_steps", double(hard.substeps), "",
               "explicit steps a frame, 24 x 24, 1e6 N/m");
    out.number("cloth_hard_ratio", hard.many / hard.factors, "",
               "explicit over factorised, 1e6 N/m", 2);
    out.number("cloth_soft_products", double(soft.products), "",
               "products of the gradients, 1e2 N/m");
    out.number("cloth_hard_products", double(hard.products), "",
               "products of the gradients, 1e6 N/m");
    out.number("cloth_hard_few", double(hard.few_products), "", "the same, to one percent");
    // Both solve one system. What is left of the right side, 1e-6 of it, may stand for a thousand
    // times as much of the motion: the matrix has eigenvalues from m to m + 8 h² k.
    out.check("cloth_solvers_agree", apart < 1e-2,
              "factors and conjugate gradients give the same step");
    bool dear = true;  // a product costs about what an explicit step costs
    for (const auto& of : {sizes, stiff})
        for (const auto& c : of) dear = dear && c.products > 2 * c.substeps;
    out.check(
        "cloth_gradients_dear", dear,
        "conjugate gradients to 1e-6 take more than twice as many products as explicit steps");
    out.check(
        "cloth_products_grow",
        hard.products > 10 * soft.products && hard.few_products < hard.products / 10,
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
