#include <iostream>

#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>

int main() {
    const auto box = timestep::box(2.0, 0.3, 0.2, 0.1);  // kg, and three sides in m
    timestep::RigidState<double> s{0, timestep::Quaternion<double>::Identity(), {0.1, 8, 0.1}};
    const double before = kinetic_energy(box, s);  // J; the last in s is ω, rad/s
    for (int n = 0; n < 600; ++n) s = step_rotation(timestep::passive_gyroscopic, box, s, 1.0 / 60);
    std::cout << "after " << s.t << " s: ω = (" << s.omega.transpose() << ") rad/s\n"
              << "energy × " << kinetic_energy(box, s) / before << "\n";
}
