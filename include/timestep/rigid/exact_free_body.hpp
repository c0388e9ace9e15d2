#pragma once
/// \file
/// The exact motion of a free body, the reference for every solver.

#include <algorithm>
#include <tuple>

#include <timestep/rigid/body.hpp>
#include <timestep/rigid/elliptic.hpp>

namespace timestep {

/// The exact solution of Euler's equations I ω̇ + ω × Iω = 0 (N40) for any three moments and any
/// start, the orientation included (Jacobi 1850; Landau and Lifshitz, *Mechanics*, section 37).
///
/// Energy and angular momentum confine ω to a closed curve round the axis of the largest or of the
/// smallest moment, and along it the components go as cn, sn and dn. Between the two families of
/// curves lies the separatrix, on which a body turns over only once. Close to it the motion is
/// sensitive: a start that differs in the last digit flips at another time.
///
/// The angle about L is a sum of large terms that cancel where the moments differ much: for each
/// radian of spin it is off by up to some 60 ε times the ratio of the largest moment to the
/// smallest. Measured in `double`, that is 1e-10 rad at a ratio of 1e4 and 1e-6 rad at 1e8.
template <class Real>
class ExactFreeBody {
public:
    /// Prepares the motion of a body from `start` on.
    ExactFreeBody(const PrincipalInertia<Real>& inertia, const RigidState<Real>& start);

    /// The state `t` seconds after the start.
    RigidState<Real> operator()(Real t) const;
    /// ω̇ in body coordinates `t` seconds after the start, rad/s²: the derivative of the formulas,
    /// independent of Euler's equations.
    Vector3<Real> acceleration(Real t) const;

private:
    using V = Vector3<Real>;
    V omega(const Elliptic<Real>& f) const;  // in the axes below
    Quaternion<Real> about_z(const V& w, Real precession) const;
    Real third_integral(const Elliptic<Real>& f, Real u) const;

    RigidState<Real> start_;
    Matrix3<Real> axes_;  // the body's axes, in an order that puts the encircled one last
    V moments_;           // in that order
    V amplitude_;         // of the three components, with signs
    Quaternion<Real> before_;
    bool steady_ = false;  // ω stays as it is
    Real L_ = 0;           // |L|
    Real rate_ = 0;        // u = u0 + rate t
    Real u0_ = 0, m1_ = 1, quarter_period_ = 0, nu_ = 0;
    Real third_at_start_ = 0, third_of_quarter_ = 0;
};

template <class Real>
ExactFreeBody<Real>::ExactFreeBody(const PrincipalInertia<Real>& inertia,
                                   const RigidState<Real>& start)
    : start_(start) {
    using std::abs, std::copysign, std::sqrt;
    const V body = start.q.conjugate() * start.omega;
    // Only the moments' ratios matter; a power of two changes no digit of them.
    const V all = inertia.moments / std::exp2(Real(std::ilogb(inertia.moments.maxCoeff())));
    // Axes by their moments: small, middle, large. The curve goes round the large one when
    // |L|² > 2 E I_middle, else round the small one.
    int order[3] = {0, 1, 2};
    std::sort(order, order + 3, [&](int i, int j) { return all[i] < all[j]; });
    const auto weight = [&](int i) {  // of the term I ω² |I − I_middle|
        return all[order[i]] * body[order[i]] * body[order[i]] * abs(all[order[i]] - all[order[1]]);
    };
    if (weight(2) < weight(0)) std::swap(order[0], order[2]);
    for (int i = 0; i < 3; ++i) axes_.col(i) = V::Unit(order[i]);
    if (axes_.determinant() < 0) axes_.col(1) = -axes_.col(1);
    moments_ = {all[order[0]], all[order[1]], all[order[2]]};
    const V w = axes_.transpose() * body;
    const auto [I1, I2, I3] = std::tuple(moments_.x(), moments_.y(), moments_.z());
    const Real d12 = abs(I2 - I1), d23 = abs(I3 - I2), d13 = abs(I3 - I1);

    // P = |2EI₃ − L²|, Q = |L² − 2EI₁|, S = |L² − 2EI₂|, written so that nothing cancels in P and
    // Q.
    const Real P = I1 * w.x() * w.x() * d13 + I2 * w.y() * w.y() * d23;
    const Real Q = I2 * w.y() * w.y() * d12 + I3 * w.z() * w.z() * d13;
    const Real S = abs(I3 * w.z() * w.z() * d23 - I1 * w.x() * w.x() * d12);
    L_ = moments_.cwiseProduct(w).norm();
    const int spins = (w.x() != 0) + (w.y() != 0) + (w.z() != 0);
    steady_ = spins < 2 || P == 0 || Q == 0;
    if (steady_) return;

    rate_ = sqrt(d23 * Q / I1 / I2 / I3);
    m1_ = std::min(Real(1), d13 * S / (d23 * Q));
    nu_ = I3 * d12 / (I1 * d23);
    // The signs: the first and last component keep theirs at the start; ω̇₁ = (I₂ − I₃)/I₁ ω₂ω₃ then
    // says which way the middle one goes.
    const Real sign1 = copysign(Real(1), w.x()), sign3 = copysign(Real(1), w.z());
    amplitude_ = {sign1 * sqrt(P / I1 / d13),
                  sign1 * sign3 * (I3 > I2 ? 1 : -1) * sqrt(P / I2 / d23),
                  sign3 * sqrt(Q / I3 / d13)};
    const V part = w.cwiseQuotient(amplitude_);
    const Elliptic<Real> f{part.y(), part.x(), part.z()};
    u0_ = f.sn * carlson_rf(f.cn * f.cn, f.dn * f.dn, Real(1));
    if (m1_ > 0) {
        quarter_period_ = carlson_rf(Real(0), m1_, Real(1));
        third_of_quarter_ = quarter_period_ - nu_ / 3 * carlson_rj(Real(0), m1_, Real(1), 1 + nu_);
    }
    third_at_start_ = third_integral(f, u0_);
    before_ = about_z(w, 0);
}

template <class Real>
RigidState<Real> ExactFreeBody<Real>::operator()(Real t) const {
    if (steady_) {
        const Real speed = start_.omega.norm();
        const V axis = speed > 0 ? V(start_.omega / speed) : V(V::UnitX());
        const Quaternion<Real> spin(Eigen::AngleAxis<Real>(speed * t, axis));
        return {start_.t + t, spin * start_.q, start_.omega};
    }
    const Real u = u0_ + rate_ * t;
    const Elliptic<Real> f = jacobi(u, m1_);
    const V w = omega(f);
    // The angle about L. Its rate is L (I₁ω₁² + I₂ω₂²)/(I₁²ω₁² + I₂²ω₂²), and put into sn
    // L/I₃ (1 + (I₃ − I₁)/I₁ / (1 + ν sn²)).
    const Real third = (third_integral(f, u) - third_at_start_) / rate_;
    const Real precession =
        L_ / moments_.z() * (t + (moments_.z() - moments_.x()) / moments_.x() * third);
    const Quaternion<Real> frame(axes_);
    const Quaternion<Real> q =
        start_.q * frame * before_.conjugate() * about_z(w, precession) * frame.conjugate();
    return {start_.t + t, q.normalized(), q.normalized() * (axes_ * w)};
}

// The derivatives by u are cn′ = −sn dn, sn′ = cn dn and dn′ = −m sn cn.
template <class Real>
Vector3<Real> ExactFreeBody<Real>::acceleration(Real t) const {
    if (steady_) return V::Zero();
    const Elliptic<Real> f = jacobi(u0_ + rate_ * t, m1_);
    const V slope(-f.sn * f.dn, f.cn * f.dn, -(1 - m1_) * f.sn * f.cn);
    return axes_ * V(rate_ * amplitude_.cwiseProduct(slope));
}

template <class Real>
Vector3<Real> ExactFreeBody<Real>::omega(const Elliptic<Real>& f) const {
    return amplitude_.cwiseProduct(V(f.cn, f.sn, f.dn));
}

// Euler's angles about z, x, z: the last two bring L = (sin θ sin χ, sin θ cos χ, cos θ) |L| to the
// z axis, the first turns about it.
template <class Real>
Quaternion<Real> ExactFreeBody<Real>::about_z(const V& w, Real precession) const {
    using std::atan2, std::hypot;
    using Turn = Eigen::AngleAxis<Real>;
    const V L = moments_.cwiseProduct(w);
    const Real theta = atan2(hypot(L.x(), L.y()), L.z());
    const Real chi = atan2(L.x(), L.y());
    return Turn(precession, V::UnitZ()) * Turn(theta, V::UnitX()) * Turn(chi, V::UnitZ());
}

// ∫ du/(1 + ν sn²u) from 0, Legendre's third kind. Over half a period, 2K, it grows by the same.
template <class Real>
Real ExactFreeBody<Real>::third_integral(const Elliptic<Real>& f, Real u) const {
    // On the separatrix itself sn is tanh u and the integral elementary.
    if (m1_ == 0) return (u + std::sqrt(nu_) * std::atan(std::sqrt(nu_) * f.sn)) / (1 + nu_);
    const Real halves = m1_ > 0 ? std::round(u / (2 * quarter_period_)) : Real(0);
    const Real sn = std::fmod(halves, Real(2)) == 0 ? f.sn : -f.sn;
    const Real c = f.cn * f.cn, d = f.dn * f.dn;
    return 2 * halves * third_of_quarter_ + sn * carlson_rf(c, d, Real(1)) -
           nu_ / 3 * sn * sn * sn * carlson_rj(c, d, Real(1), 1 + nu_ * sn * sn);
}

}  // namespace timestep
