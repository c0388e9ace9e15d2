#pragma once
// Bodies that could exist, at random, for tests. A body is given by how far its mass reaches along its
// axes, A, B and C; its moments B + C, C + A, A + B obey the triangle rule by themselves.

#include <cmath>
#include <random>

#include <timestep/rigid/inertia.hpp>

class RandomInertia {
public:
    explicit RandomInertia(unsigned long seed) : random_(seed) {}

    // Reaches even in the logarithm between 1/ratio and 1; the whole scaled by up to 1e-6.
    template <class Real>
    timestep::PrincipalInertia<Real> inertia(double ratio) {
        const double A = std::pow(ratio, -even_(random_)), B = std::pow(ratio, -even_(random_)),
                     C = std::pow(ratio, -even_(random_)), scale = std::pow(1e6, -even_(random_));
        return {Real((B + C) * scale), Real((C + A) * scale), Real((A + B) * scale)};
    }
    // A unit vector; one in eight lies on an axis or in a plane of two.
    template <class Real>
    timestep::Vector3<Real> direction() {
        timestep::Vector3<double> d(normal_(random_), normal_(random_), normal_(random_));
        const int special = int(24 * even_(random_));
        if (special < 3) d[special] = 0;
        if (special == 3) d = {0, 0, 1};
        return d.normalized().cast<Real>();
    }

private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> even_{0, 1};
    std::normal_distribution<double> normal_;
};
