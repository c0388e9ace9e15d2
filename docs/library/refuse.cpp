#include <iostream>
#include <stdexcept>

#include <timestep/models/spring.hpp>

int main() {
    std::cout << "ω = -10 is " << (timestep::Spring<double>::valid(-10.0) ? "fine" : "refused") << "\n";
    try {
        const timestep::Spring spring(-10.0);  // rad/s
        std::cout << spring.omega << "\n";
    } catch (const std::invalid_argument& wrong) {
        std::cout << wrong.what() << "\n";
    }
}
