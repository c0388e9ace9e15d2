#pragma once
/// \file
/// Stability of a step: on a linear scene with one degree of freedom it is a 2×2 matrix, whose
/// eigenvalues decide whether the scene blows up (N23).

#include <algorithm>
#include <complex>
#include <utility>

#include <timestep/checks.hpp>
#include <timestep/state.hpp>

namespace timestep {

/// The matrix A of one step: (x₂, v₂) = A (x₁, v₁).
template <class Real>
struct StepMatrix {
    Real xx;  ///< x₂ = xx x₁ + xv v₁: the factor of x₁
    Real xv;  ///< in x₂: the factor of v₁
    Real vx;  ///< v₂ = vx x₁ + vv v₁: the factor of x₁
    Real vv;  ///< in v₂: the factor of v₁

    /// The sum of the two eigenvalues.
    Real trace() const { return xx + vv; }
    /// The product of the two eigenvalues: the factor by which a step scales areas in the phase
    /// portrait.
    Real determinant() const { return xx * vv - xv * vx; }
};

/// The step matrix of a one-step method on a linear scene without a constant force: a step maps the
/// states (1, 0) and (0, 1) to its columns.
template <class Method, class Model, class Real>
requires requires(const Method& m, const Model& f, State<Real> s, Real h) { m.step(f, s, h); }
StepMatrix<Real> step_matrix(const Method& method, const Model& model, Real h) {
    const State<Real> a = method.step(model, State<Real>{0, 1, 0}, h);
    const State<Real> b = method.step(model, State<Real>{0, 0, 1}, h);
    return {a.x, b.x, a.v, b.v};
}

/// The two roots of the characteristic polynomial λ² − trace λ + determinant = 0. The radicand
/// (trace/2)² − determinant is multiplied out, so that short steps lose no digits.
template <class Real>
std::pair<std::complex<Real>, std::complex<Real>> eigenvalues(const StepMatrix<Real>& a) {
    const Real half = a.trace() / 2, apart = (a.xx - a.vv) / 2;
    const std::complex<Real> root = std::sqrt(std::complex<Real>(apart * apart + a.xv * a.vx));
    return {half + root, half - root};
}

/// The larger magnitude of the two eigenvalues: the growth per step in the long run.
template <class Real>
Real spectral_radius(const StepMatrix<Real>& a) {
    const auto [first, second] = eigenvalues(a);
    return std::max(std::abs(first), std::abs(second));
}

/// The largest h up to `longest` for which no step up to it lets the scene grow, found by
/// bisection: stable(h) must hold for small h and fail from some h on. Returns `longest` if it
/// holds there.
template <class Real, class Stable>
Real largest_stable_step(const Stable& stable, Real longest) {
    Real good = 0;
    Real bad = positive("longest", longest);
    if (stable(bad)) return bad;
    for (int i = 0; i < 100; ++i) {
        const Real middle = (good + bad) / 2;
        (stable(middle) ? good : bad) = middle;
    }
    return good;
}

}  // namespace timestep
