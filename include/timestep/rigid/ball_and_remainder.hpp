#pragma once
/// \file
/// A ball and a remainder: whole-body steps of order two and four.

#include <algorithm>

#include <timestep/rigid/axis_spin.hpp>
#include <timestep/rigid/spin_state.hpp>
#include <timestep/rigid/symmetric_about.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// A body's energy as the sum of a ball's energy and a remainder about two axes a and b,
///     ½ L·I⁻¹L = ½ |L|²/I_r + ½ A L_a² + ½ B L_b²,  A = 1/I_a − 1/I_r,  B = 1/I_b − 1/I_r.
///
/// Computed once per body. The reference r is the axis of the intermediate moment: it minimises the
/// product A B, to which a splitting's error is proportional. If two moments are equal, A or B is
/// zero and the splitting is exact.
template <class Real>
struct RemainderInertia {
    using Scalar = Real;  ///< the real number type
    int a;                ///< one of the other two axes, 0, 1 or 2
    int b;                ///< the other, 0, 1 or 2
    Real A;               ///< the remainder about a
    Real B;               ///< the remainder about b
    Real ball;            ///< 1/I_r
    Vector3<Real> unit;   ///< the moments in use: their product is one

    // r, a, b are a cyclic order. With the product one and ratio_b = (I_a − I_r)/I_b, A is
    // −ratio_b U_b², so that a small difference of two moments has lost no digit.
    /// The remainder of any three moments.
    explicit RemainderInertia(const PrincipalInertia<Real>& inertia) : unit(inertia.unit) {
        int r = 0;
        for (int i = 1; i < 3; ++i) {
            const Real j = unit[(i + 1) % 3], k = unit[(i + 2) % 3];
            if (std::min(j, k) <= unit[i] && unit[i] <= std::max(j, k)) r = i;
        }
        a = (r + 1) % 3, b = (r + 2) % 3;
        A = -inertia.ratio[b] * unit[b] * unit[b];
        B = inertia.ratio[a] * unit[a] * unit[a];
        ball = 1 / unit[r];
    }
    /// The remainder of two equal moments and another one: A or B is zero.
    explicit RemainderInertia(const SymmetricInertia<Real>& I)
        : RemainderInertia(PrincipalInertia<Real>(I.across, I.across, I.along)) {}
    /// The remainder of a symmetric body about x or y.
    template <Axis axis>
    explicit RemainderInertia(const SymmetricAbout<axis, Real>& I)
        : RemainderInertia(
              PrincipalInertia<Real>(I.moments().x(), I.moments().y(), I.moments().z())) {}
};

/// \cond
namespace detail {
// The three motions whose energies make up the whole. The ball's is a steady rotation about L,
// which is constant in the world. It commutes with the other two, so it is taken once, for the
// whole step. The motion of a is a rotation about the axis a by the angle h A L_a.
template <class Real>
struct RemainderStep {
    const RemainderInertia<Real>& inertia;
    Real h;
    AxisSpin<Real> body;

    TIMESTEP_INLINE
    RemainderStep(const RemainderInertia<Real>& inertia_, const SpinState<Real>& s, Real h_)
        : inertia(inertia_), h(h_), body{s.q, inertia_.unit.cwiseProduct(s.omega)} {
        body.q = quaternion_product(s.q, rotation_by(Vector3<Real>(h * (inertia.ball * body.L))));
    }
    TIMESTEP_INLINE void a(Real part) {
        const int i = inertia.a;
        body.spin(i, part * h * (inertia.A * body.L[i]));
    }
    TIMESTEP_INLINE void b(Real part) {
        const int i = inertia.b;
        body.spin(i, part * h * (inertia.B * body.L[i]));
    }
    TIMESTEP_INLINE SpinState<Real> end(Real t) const {
        return {t + h, over_its_length(body.q), body.L.cwiseQuotient(inertia.unit)};
    }
};
}  // namespace detail
/// \endcond

/// A splitting into a spherical top (a ball) and a remainder: half a step of a, one of b, half a
/// step of a. Order two; exact for two equal moments, and the closer a body is to a symmetric one,
/// the smaller the error beside Strang's splitting. |L| stays for any step, and with it the energy
/// stays bounded. A step of −h undoes a step of h.
///
/// The error is proportional to (hλ)², λ² = −A B |L|², and for throws near the intermediate axis
/// grows like exp(λt): λ is the rate at which a spin about that axis departs from it. A ruler's λ
/// is nearly |ω|; use BallAndRemainder4 for it. Beyond h|ω| of about 1e19 in `float`, 1e154 in
/// `double`, both return NaN.
struct BallAndRemainder2 {
    static constexpr const char* name = "ball and remainder 2";  ///< for tables and keys
    static constexpr int order = 2;                              ///< of the error after a whole run

    /// One step of `h` seconds.
    /// [two]
    template <class Real>
    TIMESTEP_INLINE SpinState<Real> step(const RemainderInertia<Real>& inertia,
                                         const SpinState<Real>& s1, Real h) const noexcept {
        detail::RemainderStep<Real> part(inertia, s1, h);
        part.a(Real(0.5));
        part.b(Real(1));
        part.a(Real(0.5));
        return part.end(s1.t);
    }
    /// [two]
    /// One step of `h` seconds that computes the remainder first.
    template <class Inertia, class Real>
    SpinState<Real> step(const Inertia& inertia, const SpinState<Real>& s1, Real h) const {
        static_assert(detail::one_real<Inertia, Real>,
                      "timestep: the inertia and the state hold one kind of number: both float, or "
                      "both double");
        return step(RemainderInertia<Real>(inertia), s1, h);
    }
};

/// The three motions of BallAndRemainder2 in parts whose errors of order two and three cancel: six
/// of b between seven of a (Blanes and Moan 2002, their S6). Order four; |L| stays for any step,
/// and a step of −h undoes a step of h.
struct BallAndRemainder4 {
    static constexpr const char* name = "ball and remainder 4";  ///< for tables and keys
    static constexpr int order = 4;                              ///< of the error after a whole run

    /// One step of `h` seconds.
    /// [four]
    template <class Real>
    TIMESTEP_INLINE SpinState<Real> step(const RemainderInertia<Real>& inertia,
                                         const SpinState<Real>& s1, Real h) const noexcept {
        constexpr Real a1 = Real(0.0792036964311957L), a2 = Real(0.353172906049774L),
                       a3 = Real(-0.0420650803577195L), a4 = 1 - 2 * (a1 + a2 + a3);
        constexpr Real b1 = Real(0.209515106613362L), b2 = Real(-0.143851773179818L),
                       b3 = Real(0.5) - b1 - b2;
        detail::RemainderStep<Real> part(inertia, s1, h);
        part.a(a1), part.b(b1), part.a(a2), part.b(b2), part.a(a3), part.b(b3);
        part.a(a4);
        part.b(b3), part.a(a3), part.b(b2), part.a(a2), part.b(b1), part.a(a1);
        return part.end(s1.t);
    }
    /// [four]
    /// One step of `h` seconds that computes the remainder first.
    template <class Inertia, class Real>
    SpinState<Real> step(const Inertia& inertia, const SpinState<Real>& s1, Real h) const {
        static_assert(detail::one_real<Inertia, Real>,
                      "timestep: the inertia and the state hold one kind of number: both float, or "
                      "both double");
        return step(RemainderInertia<Real>(inertia), s1, h);
    }
};

inline constexpr BallAndRemainder2 ball_and_remainder_2;  ///< the method as a value
inline constexpr BallAndRemainder4 ball_and_remainder_4;  ///< the method as a value

}  // namespace timestep
