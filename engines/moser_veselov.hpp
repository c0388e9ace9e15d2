#pragma once
/// \file
/// The discrete Moser-Veselov algorithm, of order two and four.

#include <cmath>
#include <limits>

#include <timestep/rigid/solve3.hpp>
#include <timestep/rigid/spin_state.hpp>

namespace timestep {

/// The motion itself made discrete, by a least action over rotations ρ from one step to the next
/// (Moser and Veselov 1991). With ρ as a unit quaternion (e₀, e) and L in the body,
///     h/2 L₁ = e₀ I₁e₁ + (I₃ − I₂) e₂e₃  and so on round;  q ← q ρ,  L ← ρ* L ρ.
/// Order two; energy and L are kept, as in the true motion. For h|ω| above 1 on an axis there is no
/// such ρ. So a longer step is taken in parts of h|ω| ≤ ½, where Newton's method always finds one
/// (by Kantorovich's theorem: no |a| is above 1, and 2 × ¼ × 1.7 is less than 1).
///
/// Order four: other moments Ĩ in the equation, made of I, of the energy and of |L| so that the
/// error of order two is gone (Hairer and Vilmart 2006). Both are kept as before. In a part each Ĩ
/// is between I and 12/11 I (seen in two million bodies with ratios up to 1e8).
template <int Order>
struct MoserVeselov {
    static_assert(Order == 2 || Order == 4, "timestep: Moser-Veselov has order two or four here");
    static constexpr const char* name = Order == 2 ? "Moser-Veselov 2" : "Moser-Veselov 4";  ///< for tables and keys
    static constexpr int order = Order;  ///< of the error after a whole run

    /// One step of `h` seconds. NaN where a step has more than a million parts.
    template <class Real>
    SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1, Real h) const {
        using std::abs, std::ceil;
        SpinState<Real> s = s1;
        for (Real left = h; left != 0;) {
            const Real parts = ceil(2 * abs(left) * s.omega.norm());
            if (!(parts < 1e6)) {
                s.omega.setConstant(std::numeric_limits<Real>::quiet_NaN());
                break;
            }
            s = whole(inertia, s, parts > 1 ? left / parts : left);
            left = parts > 1 ? left - left / parts : 0;
        }
        s.t = s1.t + h;
        return s;
    }

    // In c = e/e₀, where e₀² = 1/(1 + |c|²), the equation is quadratic. Over Ĩ₁ its first row is
    //     c₁ + a₁c₂c₃ = h/2 L₁/Ĩ₁ (1 + |c|²),  a₁ = (Ĩ₃ − Ĩ₂)/Ĩ₁.
    /// One part: a step that is not cut up, and goes wrong where there is no ρ.
    template <class Real>
    static SpinState<Real> whole(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s, Real h) {
        using V = Vector3<Real>;
        const V& U = inertia.unit;
        const V L = U.cwiseProduct(s.omega);
        const V inverse = inverse_moments(U, L, h), I = inverse.cwiseInverse();
        const V w = h / 2 * inverse.cwiseProduct(L);
        const V differences(I.z() - I.y(), I.x() - I.z(), I.y() - I.x());
        const V a = inverse.cwiseProduct(differences);
        V c = w;
        for (int i = 0; i < 8; ++i) {
            const V pairs(c.y() * c.z(), c.z() * c.x(), c.x() * c.y());
            const V residual = c + a.cwiseProduct(pairs) - (1 + c.squaredNorm()) * w;
            Matrix3<Real> J;
            J << 1, a.x() * c.z(), a.x() * c.y(), a.y() * c.z(), 1, a.y() * c.x(), a.z() * c.y(), a.z() * c.x(), 1;
            J -= 2 * w * c.transpose();
            const V change = solve3(J, residual);
            c -= change;
            const Real roundoff = std::numeric_limits<Real>::epsilon();
            if (change.norm() <= roundoff * c.norm()) break;
        }
        const Quaternion<Real> cayley(1, c.x(), c.y(), c.z());
        const Quaternion<Real> rho = cayley.normalized();
        return {s.t + h, (s.q * rho).normalized(), (rho.conjugate() * L).cwiseQuotient(U)};
    }

private:
    // 1/Ĩ = (1 + h²s)/I + h²d, with s and d of what the motion keeps; in U the product is 1.
    template <class Real>
    static Vector3<Real> inverse_moments(const Vector3<Real>& U, const Vector3<Real>& L, Real h) {
        const Vector3<Real> inverse = U.cwiseInverse();
        if constexpr (Order == 2) return inverse;
        const Real E = L.dot(inverse.cwiseProduct(L)) / 2, C = L.squaredNorm() / 2;
        const Real s = -inverse.sum() / 3 * E + U.sum() / 6 * C;
        const Real d = U.sum() / 6 * E - C / 3;
        return inverse + h * h * (s * inverse + Vector3<Real>::Constant(d));
    }
};

inline constexpr MoserVeselov<2> moser_veselov_2;  ///< the method as a value
inline constexpr MoserVeselov<4> moser_veselov_4;  ///< the method as a value

}  // namespace timestep
