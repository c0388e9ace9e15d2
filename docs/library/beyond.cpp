#include <iostream>

#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>

int main() {
    const auto box = timestep::box(2.0, 0.3, 0.2, 0.1);  // kg, and three sides in m
    timestep::SpinState<double> s{0, timestep::Quaternion<double>::Identity(), {0.1, 8, 0.1}};
    const auto right = timestep::ExactFreeBody(box, in_world(s))(2.0).q;  // after 2 s
    const timestep::RemainderInertia<double> prepared(box);               // once for each body
    for (int n = 0; n < 120; ++n) s = timestep::ball_and_remainder_4.step(prepared, s, 1.0 / 60);
    std::cout << "ball and remainder 4 is off by " << timestep::apart(s.q, right) << "\n";
}
