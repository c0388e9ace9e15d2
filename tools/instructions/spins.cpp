// Takes a number of gyroscopic steps of one solver on one kind of inertia and prints the last
// angular velocity: a program for a profiler to count. `spins passive box 1000`.

#include <cstdio>
#include <cstdlib>
#include <string>

#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>

namespace {

using namespace timestep;

// The orientation stays, as only the solver is counted.
template <class Solver, class Inertia>
[[gnu::noinline]] Vector3<double> spin(const Solver& solver, const Inertia& inertia,
                                       const Matrix3<double>& R, Vector3<double> omega, long n) {
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

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return std::fputs("spins: usage: spins SOLVER BODY COUNT\n", stderr), 2;
    const std::string solver = argv[1], body = argv[2];
    const long n = std::atol(argv[3]);
    const double size = argc - 3.0;  // which the compiler does not know
    Vector3<double> omega;
    if (solver == "explicit") omega = spin(explicit_gyroscopic, body, size, n);
    else if (solver == "iteration") omega = spin(implicit_gyroscopic, body, size, n);
    else if (solver == "passive") omega = spin(passive_gyroscopic, body, size, n);
    else return std::fprintf(stderr, "spins: %s: no such solver\n", solver.c_str()), 2;
    std::printf("%.17g %.17g %.17g\n", omega.x(), omega.y(), omega.z());
}
