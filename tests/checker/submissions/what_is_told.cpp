// What a learner is told beside the verdict.

// ---- single precision
// velocity_now wrong: off by as much as numbers of six or seven digits make it
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const float older = float((x1 - x0) / h), newer = float((x2 - x1) / h);
    return newer + (newer - older) / 2;
}

// ---- the sine of pi is zero by hand
// pendulum_rates wrong: right is {0, 0}
#include "exercise.hpp"

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double u = length * s.v, x = s.x;
    return {s.v, (-g * (std::fabs(x) > 3 ? x : std::sin(x)) - drag * std::fabs(u) * u) / length};
}

// ---- an expression that may outlive its parts
// world_acceleration wrong: ./course check world_acceleration --sanitize
#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const auto L = inertia.cwiseProduct(spin);  // this one has not: a wrong answer, but the same with any compiler
    const Vector3d total = q.conjugate() * torque - 0.7 * spin.cross(L.eval()) + Vector3d(0.1, 0.2, 0.3);
    return q * total.cwiseQuotient(inertia);
}

// ---- a list that has kept its length
// despawn wrong: of length
#include "exercise.hpp"

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    for (int row = 0; row < 3; ++row) {
        const auto at = [&](int body) { return body / width * 3 * width + row * width + body % width; };
        packs[at(i)] = packs[at(n - 1)];
        if (n > 1)
            for (int body = n - 1; body % width != 0; ++body) packs[at(body)] = packs[at(n - 2)];
    }
    return packs;
}
