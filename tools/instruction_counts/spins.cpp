// A gyroscopic step of one solver on one kind of inertia. The orientation stays, as only the solver is counted.

#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "cases.hpp"

namespace {

using namespace timestep;

template <class Solver, class Inertia>
[[gnu::noinline]] Vector3<double> spin(const Solver& solver, const Inertia& inertia, const Matrix3<double>& R,
                                       Vector3<double> omega, long n) {
    for (long i = 0; i < n; ++i) omega = after_gyroscopic_torque(solver, inertia, R, omega, 0.001);
    return omega;
}

template <class Solver>
void add(std::vector<Case>& all, const std::string& name, const Solver& solver) {
    const double size = unknown_one;
    const Matrix3<double> R = Quaternion<double>(size, 2, 3, 4).normalized().toRotationMatrix();
    const auto add_body = [&](const std::string& body, const auto& inertia) {
        all.push_back({name + "_" + body, 1000,
                       [=](long n) { kept = spin(solver, inertia, R, Vector3<double>(size, 2, 3), n).sum(); }});
    };
    const auto sides = box(10.0, size, 2.0, 3.0);
    const Matrix3<double> turned = R * sides.moments.asDiagonal() * R.transpose();
    add_body("ball", sphere(10.0, size));
    add_body("capsule", capsule(10.0, size, 2.0));
    add_body("box", sides);
    add_body("any", FullInertia<double>((turned + turned.transpose()) / 2));
}

}  // namespace

std::vector<Case> gyroscopic_solvers() {
    std::vector<Case> all;
    add(all, "explicit", explicit_gyroscopic);
    add(all, "iteration", implicit_gyroscopic);
    add(all, "passive", passive_gyroscopic);
    return all;
}
