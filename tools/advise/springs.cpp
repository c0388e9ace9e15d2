// How fast is the fastest oscillation? Springs on a body, in a chain, in a cloth, in a hinge: bounds from what is typed
// about them, without their places.

#include <algorithm>
#include <cmath>

#include <timestep/checks.hpp>

#include "method_on_spring.hpp"
#include "words.hpp"

namespace timestep {

double lightness(double mass, double arm, double inertia) {
    const double still = 1 / positive("mass", mass);
    if (not_negative("arm", arm) == 0) return still;
    return still + arm / positive("turning", inertia) * arm;
}

namespace {

void check_count(double springs) {
    if (!(springs >= 1 && springs <= 1e9 && springs == std::floor(springs)))
        refuse("springs", springs, "a whole number from 1 to 1e9");
}

// `zeta_of(omega)` is the damping ratio of an oscillation.
template <class Zeta>
SpringScene scene_with(const Pull& pull, double stiffness, const Zeta& zeta_of) {
    const double root = std::sqrt(positive("stiffness", stiffness));
    const auto swing = [&](double share) {
        return DampedSpring<double>(root * std::sqrt(share), zeta_of(std::sqrt(share) / root));
    };
    SpringScene scene(swing(pull.most), swing(pull.least), pull.found);
    scene.several = pull.several;
    scene.turns = pull.turns;
    return scene;
}

}  // namespace

Pull springs_on_body(double mass, double springs, double arm, double inertia) {
    check_count(springs);
    const double each = lightness(mass, arm, inertia);
    const std::string body = phrase(arm == 0 ? "found.body" : "found.body_that_turns");
    if (springs == 1 && arm == 0) return {each, each, body, false};
    const std::string count = springs == 1 ? "" : number(springs) + "·";
    return {springs * each, std::max(1.0, springs / 3) / mass,
            phrase("found.on_body", {{"count", count}, {"body", body}}), springs > 1, arm > 0};
}

Pull springs_between(double mass, double springs) {
    positive("mass", mass);
    check_count(springs);
    return {2 * springs / mass, 2 / mass, phrase("found.between", {{"count", number(springs)}}), true};
}

Pull hinge(double one_mass, double one, double other_mass, double other) {
    return {one + other, 1 / one_mass + 1 / other_mass, phrase("found.hinge"), true,
            one > 1 / one_mass || other > 1 / other_mass};
}

SpringScene scene_of(const Pull& pull, double stiffness, double damping) {
    not_negative("damping", damping);
    return scene_with(pull, stiffness, [&](double omega_over_k) { return damping * omega_over_k / 2; });
}

SpringScene scene_of_zeta(const Pull& pull, double stiffness, double zeta) {
    return scene_with(pull, stiffness, [&](double) { return zeta; });
}

}  // namespace timestep
