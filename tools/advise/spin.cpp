// In which direction of the spin does one step raise the energy most, and from which step on?

#include <algorithm>
#include <cmath>

#include "advise_body.hpp"

namespace timestep {

// The direction in which a step gains most, or one that gains more than `enough`. Turning the body
// half round an axis changes two signs of ω and nothing else, so two octants are all there are: ω₁,
// ω₂ > 0 with either sign of ω₃. A net of directions, finer near the axes, where a gain begins as a
// small share of a small wobble; then, from the best of them, smaller and smaller moves.
Worst worst_direction(const std::function<double(const Vector3<double>&)>& gain_towards, double enough) {
    using V = Vector3<double>;
    Worst worst;
    const auto look = [&](const V& way) {
        const V direction = way.normalized();
        double gain = gain_towards(direction);
        if (std::isnan(gain)) gain = std::numeric_limits<double>::infinity();  // 0/0: no solution
        if (gain > worst.gain) worst = {gain, direction};
        return worst.gain > enough;
    };
    // Ratios of two components, from 1e-3 to 1e3.
    for (int i = -9; i <= 9; ++i)
        for (int j = -9; j <= 9; ++j)
            for (const double sign : {-1, 1})
                if (look(V(1, std::pow(10, i / 3.0), sign * std::pow(10, j / 3.0)))) return worst;
    // Round each axis, where the first gains are needles.
    for (int axis = 0; axis < 3; ++axis)
        for (double wobble = 0.1; wobble > 5e-4; wobble /= 1.15)
            for (int k = 0; k < 64; ++k) {
                V way = V::Unit(axis);
                way[(axis + 1) % 3] = wobble * std::cos(k * 0.09817477042468103);
                way[(axis + 2) % 3] = wobble * std::sin(k * 0.09817477042468103);
                if (look(way)) return worst;
            }
    double reach = 0.3;
    while (reach > 1e-4) {
        const Worst before = worst;
        const V across = before.direction.unitOrthogonal(), third = before.direction.cross(across);
        for (int k = 0; k < 8; ++k) {
            const double angle = k * 0.7853981633974483;
            if (look(before.direction + reach * (std::cos(angle) * across + std::sin(angle) * third))) return worst;
        }
        const double rise = worst.gain - before.gain;
        if (!(rise > 1e-15 && rise > 0.01 * (before.gain - 1))) reach /= 2;
    }
    return worst;
}

// The longest step of the talk's iteration with which no direction gains. With three different
// moments the first gains begin close to the intermediate axis, where h|ω| = √(I₁I₃)/(I₃ − I₁), I₁
// the least and I₃ the largest moment. That was found by search, not proved: over random bodies no
// direction gains a thousandth below it, and some direction does a thousandth above.
double longest_safe_step(const PrincipalInertia<double>& inertia, double spin) {
    const Vector3<double>& I = inertia.unit;
    const double least = I.minCoeff(), most = I.maxCoeff();
    return std::sqrt(least) * std::sqrt(most) / (most - least) / spin;
}

// From which step on its gain has no bound. The determinant of its equations is, in the order of
// the moments I₁ < I₂ < I₃ and with a₁, a₃ > 0 > a₂ the ratios of the body,
//     1 + u² + w² − v² − 2uvw,  u² = −a₂a₃h²ω₁², v² = a₁a₃h²ω₂², w² = −a₁a₂h²ω₃²,
// where u, v and w have the signs that make the last term what it is. As |2uw| ≤ u² + w² it is at
// least (1 − |v|)(1 + |v| + u² + w²), above zero for |v| < 1; at v = 1 it is (u − w)², zero at u =
// w.
double unbounded_step(const PrincipalInertia<double>& inertia, double spin) {
    const Vector3<double>& a = inertia.ratio;
    // Of the three products only a₁a₃ is above zero.
    return 1 / std::sqrt(std::max({a.x() * a.y(), a.y() * a.z(), a.z() * a.x()})) / spin;
}

bool no_torque(const PrincipalInertia<double>& inertia) { return (inertia.ratio.array() == 0).all(); }

}  // namespace timestep
