#pragma once
// Bodies that spin freely, for tests: how they start, where steps lead, and what must stay.

#include <timestep/rigid/inertia.hpp>
#include <timestep/rigid/spin_state.hpp>

template <class Real>
timestep::SpinState<Real> spinning(const timestep::Vector3<Real>& omega) {
    return {0, timestep::Quaternion<Real>::Identity(), omega};
}
inline timestep::SpinState<double> spinning(const timestep::Vector3<double>& omega) { return spinning<double>(omega); }

template <class Method>
timestep::SpinState<double> after(Method method, const timestep::PrincipalInertia<double>& I,
                                  timestep::SpinState<double> s, double h, long steps = 1) {
    for (long n = 0; n < steps; ++n) s = method.step(I, s, h);
    return s;
}

// |L| and the energy in double, of moments in any real type.
template <class Real>
double momentum(const timestep::PrincipalInertia<Real>& I, const timestep::Vector3<Real>& w) {
    return I.moments.template cast<double>().cwiseProduct(w.template cast<double>()).norm();
}
template <class Real>
double energy(const timestep::PrincipalInertia<Real>& I, const timestep::Vector3<Real>& w) {
    return I.moments.template cast<double>().dot(w.template cast<double>().cwiseAbs2()) / 2;
}
