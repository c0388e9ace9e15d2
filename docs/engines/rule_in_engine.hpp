#pragma once
/// \file
/// What an adapter asks for each body: may a rule act on it, and what is its new spin?

#include <timestep/gyroscopic.h>
#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// The calm half-step by the plain functions of timestep/gyroscopic.h, for a body of an engine, which keeps
/// inverse moments with zero for a locked axis. The functions say what they do with odd moments: with a locked
/// axis nothing, since what holds it there takes up the torque; nothing for a ball.
struct CalmInEngine {
    /// Makes of `omega`, in the body's principal axes and in rad/s, what it is after `h` seconds. Says
    /// whether a torque may have changed it.
    static bool step(const Vector3<float>& inverse_moments, Vector3<float>& omega, float h) {
        const gyroscopic_bodyf body =
            gyroscopic_from_inverse_momentsf(inverse_moments.x(), inverse_moments.y(), inverse_moments.z());
        if (gyroscopic_idlef(&body, omega.data())) return false;
        gyroscopic_calm_half_stepf(&body, omega.data(), h);
        return true;
    }
    /// The same in `double`.
    static bool step(const Vector3<double>& inverse_moments, Vector3<double>& omega, double h) {
        const gyroscopic_body body =
            gyroscopic_from_inverse_moments(inverse_moments.x(), inverse_moments.y(), inverse_moments.z());
        if (gyroscopic_idle(&body, omega.data())) return false;
        gyroscopic_calm_half_step(&body, omega.data(), h);
        return true;
    }
};

/// Any rule of the library in its place. It leaves alone what CalmInEngine does, and moments that no body has
/// (one above the sum of the others).
template <class Solver>
struct RuleInEngine {
    /// As CalmInEngine's.
    template <class Real>
    static bool step(const Vector3<Real>& inverse_moments, Vector3<Real>& omega, Real h) {
        const Vector3<Real>& v = inverse_moments;
        if (v.minCoeff() == v.maxCoeff()) return false;
        const Vector3<Real> I = v.cwiseInverse();
        if (!I.allFinite() || !(I.minCoeff() > 0 && 2 * I.maxCoeff() <= I.sum())) return false;
        const Vector3<Real> next = Solver{}.step(PrincipalInertia<Real>(I.x(), I.y(), I.z()), omega, h);
        if (!next.allFinite()) return false;
        omega = next;
        return true;
    }
};

}  // namespace timestep
