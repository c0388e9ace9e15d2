#pragma once
/// \file
/// Many dampers, solved one after another, in a sweep there and back.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <timestep/checks.hpp>
#include <timestep/linear_solve.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// Dampers between masses. Each divides the velocity at which its two masses part, along its
/// direction n, by 1 + h c (1/m_a + 1/m_b): the damping at the new velocity of chapter 3. Where
/// dampers share a mass and are divided once each, one after another, the result depends on their
/// order, and with springs it may grow without bound. This sweep divides by the square root on the
/// way there, and by the other square root on the way back.
///
/// Use it in semi-implicit Euler, after the forces and before the positions:
///
///     v += h * (forces / m);  sweep.there_and_back(v, h);  x += h * v;
///
/// With linear springs, fixed directions and a fixed step this is stable for ω h < 2, where ω is
/// the fastest oscillation of the scene without dampers; the dampers may be as hard as they like.
/// The proof: scale u = √m v and y = √m x, in which the springs give ÿ = −K y with a symmetric K
/// that has no negative eigenvalue. A root is symmetric, with eigenvalues above 0 and up to 1. So
/// is the sweep there and back, D = MᵀM. With G = D⁻¹ − 1 ≥ 0 a step is u₂ = u₁ − h K y₁ − G u₂, y₂
/// = y₁ + h u₂, and it changes the modified energy
///     ½ u·(1 + ½G) u + ½ y·K y − ½ h u·K y   by   −¼ (u₁ + u₂)·G (u₁ + u₂),
/// which is never positive. For ω h < 2 that energy bounds u and the springs' stretch. Directions
/// that turn are not proven, and a turning wheel of springs gains energy with hard dampers. There
/// keep the sum of h c/m over the dampers at each mass at most 1: with that, the wheel of the tests
/// gains no more than it does without dampers.
///
/// For a single damper, or if every two dampers are perpendicular or share no mass, the sweep
/// equals one system of equations up to roundoff. With other dampers it is stable but not accurate
/// once h c/m is near 1: then shorten the step, or solve all of them as one system. The sweep costs
/// two divisions and two square roots for each damper.
///
/// `X` is a real number (masses on a line) or a fixed-size Eigen vector.
template <class X>
class DamperSweep {
public:
    using Real = real_of<X>;  ///< the real number type

    /// Takes the inverses of the masses, 1/kg, zero or more. A mass with inverse zero is held: no
    /// damper changes its velocity. Throws `std::invalid_argument`.
    explicit DamperSweep(std::vector<Real> inverse_masses)
        : inverse_masses_(std::move(inverse_masses)) {
        for (const Real one : inverse_masses_) not_negative("inverse mass", one);
    }

    /// Adds a damper of `c` N s/m between masses a and b, along any vector that is not zero.
    /// Between two masses that are both held it does nothing. Throws `std::invalid_argument`.
    void add(std::size_t a, std::size_t b, const X& along, Real c) {
        if (a >= inverse_masses_.size() || b >= inverse_masses_.size() || a == b)
            refuse("a damper's masses: must be two of those given");
        const Real both =
            finite("sum of the inverse masses", inverse_masses_[a] + inverse_masses_[b]);
        const Real rate = finite("damping / mass", not_negative("damping", c) * both);
        const auto share = [&](std::size_t i) {
            return both > 0 ? inverse_masses_[i] / both : Real(0);
        };
        if (!is_finite(along) || along == zero<X>())
            refuse("direction of a damper: must be finite and not zero");
        dampers_.push_back({a, b, direction(along), rate, share(a), share(b)});
    }

    /// Points damper i to another direction. Two masses in one place have no direction: if `along`
    /// is zero, the damper does nothing. Throws `std::invalid_argument`.
    void redirect(std::size_t i, const X& along) {
        if (i >= dampers_.size()) refuse("damper: must be one of those added");
        if (!is_finite(along)) refuse("direction of a damper: must be finite");
        dampers_[i].along = direction(along);
    }

    /// Damps the velocities of all masses, m/s, over a step of h seconds. Throws
    /// `std::invalid_argument`.
    void there_and_back(std::span<X> v, Real h) const {
        positive("step", h);
        if (v.size() != inverse_masses_.size()) refuse("velocities: must be one for each mass");
        for (std::size_t i = 0; i < dampers_.size(); ++i) take_root(dampers_[i], v, h);
        for (std::size_t i = dampers_.size(); i-- > 0;) take_root(dampers_[i], v, h);
    }

private:
    /// \cond
    struct Damper {
        std::size_t a, b;
        X along;                // of length 1
        Real rate;              // c (1/m_a + 1/m_b), 1/s
        Real share_a, share_b;  // of the change of velocity: the lighter mass changes more
    };
    /// \endcond

    static Real product(const X& n, const X& v) {
        if constexpr (is_number<X>)
            return n * v;
        else
            return dot(n, v);
    }

    // Divides the velocity at which a and b part by √(1 + h c (1/m_a + 1/m_b)); their momentum
    // stays.
    /// [root]
    static void take_root(const Damper& d, std::span<X> v, Real h) {
        const Real s = std::min(h * d.rate, std::numeric_limits<Real>::max());
        const Real taken =
            s /
            (1 + s + std::sqrt(1 + s));  // 1 − 1/√(1 + s), to the last digit for light dampers too
        const X change = taken * product(d.along, v[d.b] - v[d.a]) * d.along;
        v[d.a] += d.share_a * change;
        v[d.b] -= d.share_b * change;
    }
    /// [root]

    std::vector<Real> inverse_masses_;
    std::vector<Damper> dampers_;
};

}  // namespace timestep
