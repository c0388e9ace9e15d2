#pragma once
// Bodies that could exist, at random: a body is given by how far its mass reaches along its axes,
// A, B and C, even in the logarithm. Its moments B + C, C + A and A + B obey the triangle rule by
// themselves.

#include <cmath>
#include <random>

#include "methods.hpp"

class RandomBody {
public:
    explicit RandomBody(unsigned seed) : random_(seed) {}

    Body inertia(double ratio) {
        const auto reach = [&] { return std::pow(ratio, -even_(random_)); };
        const double A = reach(), B = reach(), C = reach();
        return {B + C, C + A, A + B};
    }
    Vector direction() {
        Vector d;
        do
            for (int i = 0; i < 3; ++i) d[i] = normal_(random_);
        while (d.norm() < 1e-3);
        return d.normalized();
    }

private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> even_{0, 1};
    std::normal_distribution<double> normal_;
};
