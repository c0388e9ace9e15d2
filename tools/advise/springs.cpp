// How fast is the fastest oscillation? Springs on a body, in a chain, in a cloth, in a hinge: bounds from what is typed
// about them, without their places.

#include <algorithm>
#include <cmath>

#include <timestep/checks.hpp>

#include "method_on_spring.hpp"

namespace timestep {

double lightness(double mass, double arm, double inertia) {
    const double still = 1 / positive("mass", mass);
    if (not_negative("arm", arm) == 0) return still;
    return still + arm / positive("turning", inertia) * arm;
}

Pull springs_on_body(double mass, double springs, double arm, double inertia) {
    if (!(springs >= 1 && springs <= 1e9 && springs == std::floor(springs)))
        refuse("springs", springs, "a whole number from 1 to 1e9");
    const double each = lightness(mass, arm, inertia);
    if (springs == 1 && arm == 0) return {each, each, "k/m", false};
    const std::string count = springs == 1 ? "" : number(springs) + "·";
    const std::string body = arm == 0 ? "k/m" : "k(1/m + r²/I)";
    return {springs * each, std::max(1.0, springs / 3) / mass, count + body + ", if all pull at one end, one way",
            springs > 1, arm > 0};
}

Pull springs_between(double mass, double springs) {
    positive("mass", mass);
    if (!(springs >= 1 && springs <= 1e9 && springs == std::floor(springs)))
        refuse("springs", springs, "a whole number from 1 to 1e9");
    return {2 * springs / mass, 2 / mass, "2·" + number(springs) + "k/m, neighbours against each other", true};
}

Pull hinge(double one_mass, double one, double other_mass, double other) {
    return {one + other, 1 / one_mass + 1 / other_mass, "k(1/m₁ + r₁²/I₁ + 1/m₂ + r₂²/I₂), pulling across both arms",
            true, one > 1 / one_mass || other > 1 / other_mass};
}

SpringScene scene_of(const Pull& pull, double stiffness, double damping) {
    const double root = std::sqrt(positive("stiffness", stiffness));
    not_negative("damping", damping);
    const auto swing = [&](double share) {
        const double omega = root * std::sqrt(share);
        return DampedSpring<double>(omega, damping / root * std::sqrt(share) / 2);
    };
    SpringScene scene(swing(pull.most), swing(pull.least), pull.found);
    scene.several = pull.several;
    scene.turns = pull.turns;
    return scene;
}

SpringScene scene_of_zeta(const Pull& pull, double stiffness, double zeta) {
    const double root = std::sqrt(positive("stiffness", stiffness));
    SpringScene scene(DampedSpring<double>(root * std::sqrt(pull.most), zeta),
                      DampedSpring<double>(root * std::sqrt(pull.least), zeta), pull.found);
    scene.several = pull.several;
    scene.turns = pull.turns;
    return scene;
}

}  // namespace timestep
