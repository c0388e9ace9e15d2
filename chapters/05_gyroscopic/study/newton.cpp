// Newton-Raphson on the implicit step: how fast it closes in, and how many rounds a spin needs.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "random_body.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;

// What is missing in I(ω₂ − ω₁) + h ω₂ × Iω₂ = 0, and its derivative by ω₂.
V residual(const Matrix3<double>& I, const V& omega1, const V& omega2, double h) {
    return I * (omega2 - omega1) + h * omega2.cross(I * omega2);
}
Matrix3<double> jacobian(const Matrix3<double>& I, const V& omega2, double h) {
    return I + h * (skew(omega2) * I - skew(V(I * omega2)));
}

// Rounds until the residual is down to roundoff; 50 if it never is. `observe` sees it each round.
template <class Observe>
int rounds(const Matrix3<double>& I, const V& omega1, double h, const Observe& observe) {
    V omega2 = omega1;
    for (int n = 0;; ++n) {
        const V f = residual(I, omega1, omega2, h);
        const double left = f.norm() / (I * omega1).norm();
        observe(n, left);
        if (left < 1e-13 || n == 50 || !std::isfinite(left)) return left < 1e-13 ? n : 50;
        omega2 -= solve3(jacobian(I, omega2, h), f);
    }
}

}  // namespace

void newton(const Settings&, lab::Findings& out) {
    out.section("Newton-Raphson on the implicit step");
    const Matrix3<double> I = box(12.0, 1.0, 2.0, 3.0).moments.asDiagonal();
    const V omega = V(1, 2, 2) / 3;

    // The derivative against a difference of the residual. The central difference is off by d²/6
    // times the third derivative, which is zero for a quadratic; rounding leaves some ε |Iω|/d.
    double worst = 0;
    const double d = 1e-4;
    for (int i = 0; i < 3; ++i) {
        const V e = V::Unit(i) * d;
        const V difference = (residual(I, omega, omega + e, 1) - residual(I, omega, omega - e, 1)) / (2 * d);
        worst = std::max(worst, (difference - jacobian(I, omega, 1).col(i)).norm() / I.norm());
    }
    std::printf("  the Jacobian differs from a difference by %.1e\n", worst);
    out.check("jacobian", worst < 1e-7, "the Jacobian is the derivative of the residual");

    // h|ω| of 0.1, 0.5 and 1.
    auto& table = out.table("newton.tsv", {"round", "tenth", "half", "one"});
    std::vector<std::vector<double>> left(3, std::vector<double>(7, std::nan("")));
    const double sizes[] = {0.1, 0.5, 1};
    for (int k = 0; k < 3; ++k)
        rounds(I, omega, sizes[k], [&](int n, double r) {
            if (n < 7) left[k][n] = std::max(r, 1e-17);
        });
    // A search that is over leaves "-", which gnuplot does not draw.
    const auto cell = [](double r) { return std::isnan(r) ? lab::Cell("-") : lab::Cell(r); };
    for (int n = 0; n < 7; ++n) table.row({double(n), cell(left[0][n]), cell(left[1][n]), cell(left[2][n])});
    std::printf("  residual after iterations 0 to 3 at h|omega| = 0.1: %.1e %.1e %.1e %.1e\n", left[0][0], left[0][1],
                left[0][2], left[0][3]);
    for (int n = 0; n < 3; ++n)
        out.number("newton_left_" + std::to_string(n), left[0][n], "", "residual after that many iterations", 2);
    // Quadratic: the residual after a round is a constant times the square of that before it.
    const double first = left[0][1] / (left[0][0] * left[0][0]), second = left[0][2] / (left[0][1] * left[0][1]);
    out.number("newton_of_square", std::sqrt(first * second), "",
               "what an iteration leaves, over the residual's square", 1);
    out.check("newton_quadratic", second < 2 * first && first < 2 * second,
              "two iterations leave the residual's square times numbers that differ by less than 2 "
              "times");

    // Random boxes: rounds needed, and how often they do not suffice.
    auto& needed = out.table("newton_rounds.tsv",
                             {"$h\\lvert\\omega\\rvert$", "iterations, median", "iterations, largest", "not found"});
    RandomBody random(1);
    double missed_at_3 = 0;
    for (const double size : {0.01, 0.1, 0.3, 1.0, 3.0}) {
        std::vector<int> counts;
        int missed = 0;
        for (int i = 0; i < 2000; ++i) {
            const auto inertia = random.inertia(1000);
            const int n = rounds(inertia.moments.asDiagonal(), random.direction(), size, [](int, double) {});
            n == 50 ? void(++missed) : counts.push_back(n);
        }
        std::sort(counts.begin(), counts.end());
        char share[16];
        std::snprintf(share, sizeof share, "%.2g %%", 100.0 * missed / 2000);
        needed.row({size, double(counts[counts.size() / 2]), double(counts.back()), std::string(share)});
        if (size == 3.0) missed_at_3 = 100.0 * missed / 2000;
    }
    out.number("newton_missed", missed_at_3, "%", "random bodies for which plain Newton-Raphson fails at h|omega| = 3",
               2);
    out.check("newton_misses", missed_at_3 > 0.5,
              "plain Newton-Raphson misses the root of some bodies at h|omega| = 3");

    // A capsule: the equations are linear, so one iteration is the solution.
    const auto pill = capsule(1.0, 0.15, 0.6);
    double apart = 0;
    for (int i = 0; i < 1000; ++i) {
        const V w = random.direction() * 60;
        const V one = implicit_gyroscopic.step(pill, w, 1.0 / 60), all = converged_gyroscopic.step(pill, w, 1.0 / 60);
        const V general =
            converged_gyroscopic.step(PrincipalInertia<double>(pill.across, pill.across, pill.along), w, 1.0 / 60);
        apart = std::max({apart, (one - all).norm() / 60, (one - general).norm() / 60});
    }
    out.check("capsule_one_round", apart < 1e-12, "for a capsule one iteration is the solution");
}
