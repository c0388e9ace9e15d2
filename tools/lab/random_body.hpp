#pragma once
// Bodies that could exist, at random.

#include <cmath>
#include <random>

#include <timestep/rigid/inertia.hpp>

// A, B and C, the means of x², y² and z², are even in the logarithm between 1/ratio and 1. The moments B + C, C + A and
// A + B always keep the triangle rule.
class RandomBody {
public:
    explicit RandomBody(unsigned long seed) : random_(seed) {}

    timestep::PrincipalInertia<double> inertia(double ratio) {
        const auto reach = [&] { return std::pow(ratio, -share()); };
        const double A = reach(), B = reach(), C = reach();
        return {B + C, C + A, A + B};
    }
    timestep::Vector3<double> direction() {
        timestep::Vector3<double> d;
        do
            for (int i = 0; i < 3; ++i) d[i] = normal_(random_);
        while (d.norm() < 1e-3);
        return d.normalized();
    }
    double share() { return even_(random_); }  // from 0 to 1, each as likely as any other

private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> even_{0, 1};
    std::normal_distribution<double> normal_;
};
