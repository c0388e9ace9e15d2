// Chapter 8: the talk's solver, and the same with one token changed.
//
//   c++ -std=c++20 -O2 -Iinclude -I/usr/include/eigen3 chapters/08_beyond_the_talk/beyond_the_talk.cpp -o token && ./token

#include <cmath>
#include <fstream>
#include <iostream>

#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/spin_state.hpp>

using namespace timestep;

// Play with these.
const PrincipalInertia<double> box(13, 10, 5);  // kg m²: 1 by 2 by 3 metres, 12 kg
const Vector3<double> spin(1e-3, 10, 1e-3);     // rad/s, in the axes of the box: the middle one
const double h = 1.0 / 60;                      // s
const int seconds = 12;

// I (ω₂ − ω₁) = −h ω × Iω, solved by one iteration of Newton–Raphson.
// Its Jacobian is I + h G in the talk.
// With I + (h/2) G the mean of the torques at both ends acts: order two, for the same price.
template <class Solver>
void follow(const Solver& solver, std::ofstream& data) {
    Vector3<double> omega = spin;
    const double start = kinetic_energy(box, omega);
    // The motion as Jacobi solved it, by elliptic functions: at any time, without a step.
    const ExactFreeBody exact(box, RigidState<double>{0, Quaternion<double>::Identity(), spin});

    data << "# " << solver.name << '\n';
    const int steps = static_cast<int>(std::lround(seconds / h));
    double left = 1;
    for (int n = 0; n <= steps; ++n) {
        if (n > 0) omega = solver.step(box, omega, h);
        left = kinetic_energy(box, omega) / start;
        const double truth = in_body(exact(n * h)).omega.y();
        data << n * h << ' ' << left << ' ' << omega.y() << ' ' << truth << '\n';
    }
    data << "\n\n";
    std::cout << solver.name << ": after " << steps * h << " s the energy is " << 100 * left
              << " % of that at the start\n";
}

int main() {
    std::ofstream data("one_token.dat");
    follow(implicit_gyroscopic, data);
    follow(half_step_jacobian, data);
    if (!data.flush()) return std::cerr << "one_token.dat: cannot be written\n", 2;
}
