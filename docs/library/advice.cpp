#include <iostream>

#include <timestep/advise_recommend.hpp>

int main() {
    const timestep::DampedSpring spring(100.0, 0.05);     // ω in rad/s, ζ
    const auto all = timestep::advise(spring, 1.0 / 60);  // at 60 steps a second
    for (const timestep::Advice& each : all) std::cout << each.method << ": " << words(each.verdict) << "\n";
    const auto take = timestep::recommend(spring, 1.0 / 60, timestep::Wish{}, all);
    std::cout << "take " << take.method << ", " << take.substeps << " substeps\n";
}
