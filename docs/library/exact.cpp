#include <iostream>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/free_body.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/run.hpp>

int main() {
    const auto box = timestep::box(2.0, 0.3, 0.2, 0.1);  // kg, and three sides in m
    const timestep::RigidState<double> start{0, timestep::Quaternion<double>::Identity(), {0.1, 8, 0.1}};  // ω in rad/s
    const auto end = timestep::run(timestep::runge_kutta_4, timestep::FreeBody(box), stacked(start), 1.0 / 60, 120);
    const auto right = timestep::ExactFreeBody(box, start)(2.0).q;  // after 2 s
    std::cout << "RK4 is off by " << timestep::apart(unstacked(end).q, right) << "\n";
}
