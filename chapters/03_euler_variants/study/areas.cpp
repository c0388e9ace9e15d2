// A cloud of states, stepped: extrapolation spreads it, interpolation shrinks it, the mixture keeps
// its area.

#include <cstdio>
#include <vector>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// The area inside a polygon of states, by the shoelace formula.
double area(const std::vector<State<double>>& cloud) {
    double twice = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const auto& a = cloud[i];
        const auto& b = cloud[(i + 1) % cloud.size()];
        twice += a.x * b.v - b.x * a.v;
    }
    return std::fabs(twice) / 2;
}

template <class Method>
void follow(const Method& method, const Settings& settings, lab::Findings& out) {
    const Spring spring(settings.omega);
    const double determinant = step_matrix(method, spring, settings.step).determinant();
    auto& table = out.table("cloud_" + lab::id(Method::name) + ".tsv", {"x", "v_over_omega"});
    std::vector<State<double>> cloud;
    for (int i = 0; i < 90; ++i) {
        const double angle = i * pi / 45;
        cloud.push_back({0, 1 + 0.25 * std::cos(angle), 0.25 * settings.omega * std::sin(angle)});
    }
    const double before = area(cloud);
    const int steps = 36;
    for (int i = 0; i <= steps; ++i) {
        if (i % 9 == 0) {
            for (const auto& s : cloud) table.row({s.x, s.v / settings.omega});
            table.row({cloud[0].x, cloud[0].v / settings.omega});
            table.gap();
        }
        if (i < steps)
            for (auto& s : cloud) s = method.step(spring, s, settings.step);
    }
    const double ratio = area(cloud) / before, predicted = std::pow(determinant, steps);
    std::printf("  %-20s det A = %.6g: after %d steps the area is x %.5g\n", Method::name, determinant, steps, ratio);
    const std::string id = lab::id(Method::name);
    out.number(id + "_area", ratio, "", "area of the cloud after the steps, over the area before");
    out.number(id + "_area_steps", steps, "", "steps of the cloud");
    // Sums of 90 products, each rounded by a few ε of its size. When the cloud has grown long and
    // thin they cancel, and what rounding leaves is no area.
    double products = 0;
    for (const auto& s : cloud) products = std::max(products, std::fabs(s.x * s.v));
    const double lost = 90 * 8 * 2.2e-16 * products / before / predicted;
    if (lost > 0.01) std::printf("  %-20s (lost in roundoff: the cloud is too long and thin)\n", "");
    out.check(id + "_area", std::fabs(ratio / predicted - 1) < 1e-10 + lost,
              std::string(Method::name) + " multiplies areas by the determinant of its matrix");
}

}  // namespace

void areas(const Settings& settings, lab::Findings& out) {
    out.section("A cloud of states");
    follow(explicit_euler, settings, out);
    follow(implicit_euler, settings, out);
    follow(semi_implicit_euler, settings, out);
}
