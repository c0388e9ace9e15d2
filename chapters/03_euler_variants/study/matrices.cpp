// Matrices and complex numbers, as far as the chapter needs them: what a step makes of the unit
// square, and the number that explicit Euler multiplies a spring's state by.

#include <complex>
#include <cstdio>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using Complex = std::complex<double>;
constexpr double wh = 0.5;  // radians a step; ω = 1, so that v is v/ω
constexpr int steps = 9;
constexpr double corners[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};

// The columns of the matrix are two sides of what the unit square becomes.
template <class Method>
void square(const Method& method, lab::Findings& out) {
    const StepMatrix<double> a = step_matrix(method, Spring(1.0), wh);
    auto& table = out.table("square_" + lab::id(Method::name) + ".tsv", {"x", "v_over_omega"});
    for (const auto& [x, v] : corners) table.row({a.xx * x + a.xv * v, a.vx * x + a.vv * v});
    out.number("square_" + lab::id(Method::name), a.determinant(), "",
               "area of the unit square after a step of 0.5 rad", 3);
    std::printf("  %-20s makes an area of %.4g of the unit square\n", Method::name, a.determinant());
}

// Is each step of `method` a product with `factor`? The state is x + i v/ω. Leaves the run as it
// went.
template <class Method>
bool multiplies_by(const Method& method, Complex factor, lab::Findings& out) {
    auto& table = out.table("powers_" + lab::id(Method::name) + ".tsv", {"x", "v_over_omega"});
    State<double> state{0, 1, 0};
    Complex power = 1;
    double worst = 0;
    for (int n = 0; n <= steps; ++n) {
        table.row({state.x, state.v});
        worst = std::max(worst, std::abs(Complex(state.x, state.v) - power) / std::abs(power));
        state = method.step(Spring(1.0), state, wh);
        power *= factor;
    }
    return worst < 1e-14;
}

}  // namespace

void matrices(const Settings&, lab::Findings& out) {
    out.section("A matrix, a determinant, a complex number");
    auto& before = out.table("square_before.tsv", {"x", "v_over_omega"});
    for (const auto& [x, v] : corners) before.row({x, v});
    square(explicit_euler, out);
    square(implicit_euler, out);
    square(semi_implicit_euler, out);

    const Complex one_step(1, -wh);
    out.number("stretch", std::abs(one_step), "", "what a step of explicit Euler of 0.5 rad multiplies lengths by");
    out.number("turn", -std::arg(one_step) * 180 / pi, "°", "how far it turns", 3);
    out.number("true_turn", wh * 180 / pi, "°", "how far the true motion turns", 3);
    out.number("stretch_later", std::pow(std::abs(one_step), steps), "", "the same after nine steps");
    const bool both = multiplies_by(explicit_euler, one_step, out) &&
                      multiplies_by(implicit_euler, 1.0 / (1.0 + Complex(0, wh)), out);
    out.check("steps_are_products", both,
              "explicit Euler multiplies x + i v/ω by 1 − iωh, and implicit Euler divides it by 1 + iωh");
    auto& exact = out.table("powers_exact.tsv", {"x", "v_over_omega"});
    for (int n = 0; n <= steps; ++n) exact.row({std::cos(n * wh), -std::sin(n * wh)});

    const int parts = 1000;
    const double missing = std::abs(std::pow(1.0 + Complex(0, -wh) / double(parts), parts) - std::polar(1.0, -wh));
    out.number("parts_miss", missing, "", "how far a thousand parts of a step are from a turn by 0.5 rad", 2);
    out.check("many_parts_turn", missing < 1e-3,
              "a thousand small steps of explicit Euler turn by ωh and hardly stretch");
}
