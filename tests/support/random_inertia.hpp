#pragma once
// Bodies that could exist, at random, for tests: of any size, and with spins about an axis among others.

#include <cmath>

#include "random_body.hpp"

class RandomInertia {
public:
    explicit RandomInertia(unsigned long seed) : body_(seed) {}

    // The whole scaled by up to 1e-6.
    template <class Real>
    timestep::PrincipalInertia<Real> inertia(double ratio) {
        const timestep::Vector3<double> moments = body_.inertia(ratio).moments;
        const timestep::Vector3<double> scaled = moments * std::pow(1e6, -body_.share());
        return {Real(scaled.x()), Real(scaled.y()), Real(scaled.z())};
    }
    // A unit vector; one in eight lies on an axis or in a plane of two.
    template <class Real>
    timestep::Vector3<Real> direction() {
        timestep::Vector3<double> d = body_.direction();
        const int special = int(24 * body_.share());
        if (special < 3) d[special] = 0;
        if (special == 3) d = {0, 0, 1};
        return d.normalized().cast<Real>();
    }

private:
    RandomBody body_;
};
