#include "property_eigen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace checker {

namespace {

// While round numbers are drawn (Draw::real), a direction is one of few digits, too, in any order
// and with any signs.
bool is_round(double z, double longitude) {
    const auto is_whole = [](double x) { return std::fabs(x - std::round(x)) < 1e-9; };
    return is_whole(10 * z) && is_whole(2 * longitude);
}

template <std::size_t N>
std::array<double, N> in_any_order(std::array<double, N> numbers, unsigned choice) {
    for (std::size_t i = N; i > 1; --i) {
        std::swap(numbers[i - 1], numbers[choice % i]);
        choice /= unsigned(i);
    }
    for (double& number : numbers) number = choice % 2 == 0 ? number : -number, choice /= 2;
    return numbers;
}

unsigned choice_of(double z, double longitude) {
    return unsigned(std::lround(10 * z) + 10) * 7919u + unsigned(std::lround(2 * longitude)) * 104729u;
}

}  // namespace

// Archimedes: height and longitude uniform make the sphere uniform.
Eigen::Vector3d draw_direction(Draw& draw) {
    if (draw.is_roundest() && draw.choice(4) > 0) {
        constexpr std::array<double, 3> axis{1, 0, 0}, in_a_plane{0.6, 0.8, 0};
        const auto [a, b, c] = in_any_order(draw.choice(2) == 0 ? axis : in_a_plane, draw.choice(1u << 16));
        return {a + 0.0, b + 0.0, c + 0.0};  // no -0
    }
    const double z = draw.real(-1, 1), longitude = draw.real(0, 2 * std::numbers::pi);
    if (is_round(z, longitude)) {
        constexpr std::array<double, 3> of_few_digits[] = {
            {0.48, 0.6, 0.64}, {0.36, 0.48, 0.8}, {0.352, 0.36, 0.864}, {0.192, 0.64, 0.744}, {0.168, 0.224, 0.96}};
        const unsigned choice = choice_of(z, longitude);
        const auto [a, b, c] = in_any_order(of_few_digits[choice % 5], choice / 5);
        return {a, b, c};
    }
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(longitude), r * std::sin(longitude), z};
}

Eigen::Quaterniond draw_rotation(Draw& draw) {
    if (draw.is_roundest() && draw.choice(4) > 0) {
        constexpr std::array<double, 4> none{1, 0, 0, 0}, in_a_plane{0.6, 0.8, 0, 0}, third{0.5, 0.5, 0.5, 0.5};
        const unsigned which = draw.choice(3), order = draw.choice(1u << 16);
        const auto [w, x, y, z] = in_any_order(which == 0 ? none : which == 1 ? in_a_plane : third, order);
        return {w + 0.0, x + 0.0, y + 0.0, z + 0.0};
    }
    const double angle = draw.real(0, 2 * std::numbers::pi);
    const Eigen::Vector3d axis = draw_direction(draw);
    if (is_round(0, angle) && is_round(axis.z() * 100, 0)) {
        constexpr std::array<double, 4> of_few_digits[] = {
            {0.2, 0.4, 0.4, 0.8}, {0.1, 0.3, 0.3, 0.9}, {0.1, 0.5, 0.5, 0.7}, {0.1, 0.1, 0.7, 0.7}};
        const unsigned choice = choice_of(axis.x(), angle) + choice_of(axis.y(), axis.z());
        const auto [w, x, y, z] = in_any_order(of_few_digits[choice % 4], choice / 4);
        return {w, x, y, z};
    }
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

// I₁ = Σmy² + Σmz² and so on: any three second moments of mass that are not negative make a body.
Eigen::Vector3d draw_moments(Draw& draw, double ratio) {
    const double size = draw.log(0.01, 100);
    for (;;) {
        const double x = draw.log(1 / ratio, 1), y = draw.log(1 / ratio, 1), z = draw.log(1 / ratio, 1);
        const Eigen::Vector3d moments(y + z, z + x, x + y);
        if (moments.maxCoeff() <= ratio * moments.minCoeff()) return size * moments;
    }
}

Eigen::Vector3d draw_rod(Draw& draw, double least, double ratio) {
    const double across = least * draw.log(1, ratio), more = std::min(across + draw.real(0, 1) * least, least * ratio);
    return {least, across, more};
}

bool is_of_a_body(const Eigen::Vector3d& inertia) {
    return inertia.minCoeff() > 0 && 2 * inertia.maxCoeff() <= inertia.sum() * (1 + 1e-12);
}

}  // namespace checker
