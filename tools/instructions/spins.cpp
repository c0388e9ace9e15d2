// Takes a number of gyroscopic steps of one solver on one kind of inertia, or of several, one after the other: a
// program for a profiler to count. `spins passive box 1000`.

#include <cstdio>
#include <cstdlib>
#include <string>

#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "count.hpp"

namespace {

using namespace timestep;

// The orientation stays, as only the solver is counted.
template <class Solver, class Inertia>
[[gnu::noinline]] Vector3<double> spin(const Solver& solver, const Inertia& inertia, const Matrix3<double>& R,
                                       Vector3<double> omega, long n) {
    for (long i = 0; i < n; ++i) omega = after_gyroscopic_torque(solver, inertia, R, omega, 0.001);
    return omega;
}

template <class Solver>
Vector3<double> spin(const Solver& solver, const std::string& body, double size, long n) {
    const Matrix3<double> R = Quaternion<double>(size, 2, 3, 4).normalized().toRotationMatrix();
    const Vector3<double> omega(size, 2, 3);
    const auto sides = box(10.0, size, 2.0, 3.0);
    if (body == "ball") return spin(solver, sphere(10.0, size), R, omega, n);
    if (body == "capsule") return spin(solver, capsule(10.0, size, 2.0), R, omega, n);
    if (body == "box") return spin(solver, sides, R, omega, n);
    if (body == "any") {
        const Matrix3<double> turned = R * sides.moments.asDiagonal() * R.transpose();
        return spin(solver, FullInertia<double>((turned + turned.transpose()) / 2), R, omega, n);
    }
    std::fprintf(stderr, "spins: %s: no such body\n", body.c_str());
    std::exit(2);
}

void take(const std::string& solver, const std::string& body, long n) {
    const double size = unknown_one;
    Vector3<double> omega;
    if (solver == "explicit")
        omega = spin(explicit_gyroscopic, body, size, n);
    else if (solver == "iteration")
        omega = spin(implicit_gyroscopic, body, size, n);
    else if (solver == "passive")
        omega = spin(passive_gyroscopic, body, size, n);
    else
        std::exit((std::fprintf(stderr, "spins: %s: no such solver\n", solver.c_str()), 2));
    kept = omega.sum();
}

}  // namespace

int main(int argc, char** argv) {
    const auto one = [](char** words, long n) { take(words[0], words[1], n); };
    if (!count_all(argc, argv, 2, one)) return std::fputs("spins: usage: spins SOLVER BODY COUNT ...\n", stderr), 2;
}
