#include <iostream>

#include <timestep/game_loop.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/damped_spring.hpp>

int main() {
    const timestep::DampedSpring legs(10.0, 0.5);        // ω in rad/s, ζ
    timestep::State body{0, 0.3, 0.0};                   // s, m, m/s
    timestep::GameLoop loop(1.0 / 60, 8);                // steps of 1/60 s, at most 8 a frame
    for (const double passed : {0.010, 0.020, 0.035}) {  // frames, s
        const long steps =
            loop.frame(passed, [&](double h) { body = timestep::semi_implicit_euler.step(legs, body, h); });
        std::cout << steps << " steps, at " << body.x << " m\n";
    }
}
