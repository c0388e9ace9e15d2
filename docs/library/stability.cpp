#include <iostream>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/stability_limit.hpp>

int main() {
    const double omega = 120, zeta = 0.1;  // rad/s, no unit
    const auto say = [&](const auto& method) {
        const double limit = timestep::stability_limit(method, zeta).value;  // of ωh
        std::cout << method.name << ": steps up to " << 1000 * limit / omega << " ms\n";
    };
    say(timestep::semi_implicit_euler_new_damping);
    say(timestep::runge_kutta_4);
}
