#include <iostream>

#include <timestep/methods.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

int main() {
    const timestep::Spring spring(10.0);       // ω in rad/s
    const timestep::State start{0, 1.0, 0.0};  // s, m, m/s
    timestep::for_each_method([&](const auto& method) {
        const timestep::State end = timestep::run(method, spring, start, 1.0 / 60, 60);
        const double times = spring.energy(end) / spring.energy(start);
        std::cout << method.name << ": energy × " << times << "\n";
    });
}
