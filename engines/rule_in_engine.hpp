#pragma once
/// \file
/// What an adapter asks for each body: may a rule act on it, and what is its new spin?

#include <optional>

#include <timestep/gyroscopic.h>
#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// The calm half-step by the plain functions of timestep/gyroscopic.h, for a body of an engine, which keeps
/// inverse moments with zero for a locked axis. The functions say what they do with odd moments: with a locked
/// axis nothing, since what holds it there takes up the torque; nothing for a ball.
struct CalmInEngine {
    /// What is computed of the moments, once.
    static gyroscopic_bodyf body(const Vector3<float>& inverse) {
        return gyroscopic_from_inverse_momentsf(inverse.x(), inverse.y(), inverse.z());
    }
    /// The same in `double`.
    static gyroscopic_body body(const Vector3<double>& inverse) {
        return gyroscopic_from_inverse_moments(inverse.x(), inverse.y(), inverse.z());
    }
    /// Makes of `omega`, in the body's principal axes and in rad/s, what it is after `h` seconds. Says
    /// whether a torque may have changed it.
    static bool step(const gyroscopic_bodyf& body, Vector3<float>& omega, float h) {
        if (gyroscopic_idlef(&body, omega.data())) return false;
        gyroscopic_calm_half_stepf(&body, omega.data(), h);
        return true;
    }
    /// The same in `double`.
    static bool step(const gyroscopic_body& body, Vector3<double>& omega, double h) {
        if (gyroscopic_idle(&body, omega.data())) return false;
        gyroscopic_calm_half_step(&body, omega.data(), h);
        return true;
    }
};

/// Any rule of the library in its place. It leaves alone what CalmInEngine does, and moments that no body has
/// (one above the sum of the others).
template <class Solver>
struct RuleInEngine {
    /// As CalmInEngine's: the inertia, where there is one to act on.
    template <class Real>
    static std::optional<PrincipalInertia<Real>> body(const Vector3<Real>& inverse) {
        const Vector3<Real> I = inverse.cwiseInverse();
        if (inverse.minCoeff() == inverse.maxCoeff() || !PrincipalInertia<Real>::valid(I.x(), I.y(), I.z())) return {};
        return PrincipalInertia<Real>(I.x(), I.y(), I.z());
    }
    /// As CalmInEngine's.
    template <class Real>
    static bool step(const std::optional<PrincipalInertia<Real>>& body, Vector3<Real>& omega, Real h) {
        if (!body) return false;
        const Vector3<Real> next = Solver{}.step(*body, omega, h);
        if (!next.allFinite()) return false;
        omega = next;
        return true;
    }
};

}  // namespace timestep
