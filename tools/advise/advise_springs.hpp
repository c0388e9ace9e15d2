#pragma once
/// \file
/// How fast is the fastest oscillation? Springs on a body, in a chain, in a cloth, in a hinge:
/// bounds from what is typed about them, without their places (I13).

#include <algorithm>
#include <cmath>
#include <string>

#include "advise_verdict.hpp"
#include <timestep/checks.hpp>

namespace timestep {

/// How the springs of a scene pull: the stiffness of one of them times this is ω² of the fastest
/// oscillation. Where they take hold, and in which direction, is not asked, so there is a bound on
/// either side.
struct Pull {
    double most;         ///< 1/kg
    double least;        ///< 1/kg
    std::string found;   ///< the formula, in words
    bool several;        ///< several springs or directions, each with a damper of its own
    bool turns = false;  ///< does a spring take hold off a centre of mass, so that it turns a body?
};

/// What a spring feels of a body that it takes hold of at the distance `arm` from its centre of
/// mass: 1/m + r²/I at most, with the least moment of inertia I, where it pulls across the arm
/// about that axis. 1/kg. Throws `std::invalid_argument`.
inline double lightness(double mass, double arm, double inertia) {
    const double still = 1 / positive("mass", mass);
    if (not_negative("arm", arm) == 0) return still;
    return still + arm / positive("turning", inertia) * arm;
}

/// `springs` springs between the world and one body. All of them in one place, pulling one way, are
/// the fastest. At least there is the oscillation of one spring that pulls at the centre of mass,
/// and of three directions one in which a third of all of them pull.
inline Pull springs_on_body(double mass, double springs, double arm = 0, double inertia = 0) {
    if (!(springs >= 1 && springs <= 1e9 && springs == std::floor(springs)))
        refuse("springs", springs, "a whole number from 1 to 1e9");
    const double each = lightness(mass, arm, inertia);
    if (springs == 1 && arm == 0) return {each, each, "k/m", false};
    const std::string count = springs == 1 ? "" : detail::number(springs) + "·";
    const std::string body = arm == 0 ? "k/m" : "k(1/m + r²/I)";
    return {springs * each, std::max(1.0, springs / 3) / mass, count + body + ", if all pull at one end, one way",
            springs > 1, arm > 0};
}

/// Points of equal mass, each with `springs` springs to its neighbours: two in a chain, four in a
/// cloth. Two neighbours that swing against each other stretch a spring from both ends. At least
/// one pair does.
inline Pull springs_between(double mass, double springs) {
    positive("mass", mass);
    if (!(springs >= 1 && springs <= 1e9 && springs == std::floor(springs)))
        refuse("springs", springs, "a whole number from 1 to 1e9");
    return {2 * springs / mass, 2 / mass, "2·" + detail::number(springs) + "k/m, neighbours against each other", true};
}

/// One spring that holds two bodies together; `one` and `other` are their lightness() at its ends.
inline Pull hinge(double one_mass, double one, double other_mass, double other) {
    return {one + other, 1 / one_mass + 1 / other_mass, "k(1/m₁ + r₁²/I₁ + 1/m₂ + r₂²/I₂), pulling across both arms",
            true, one > 1 / one_mass || other > 1 / other_mass};
}

/// The scene of these springs, each with the damper `damping`, N·s/m, beside it: an oscillation of
/// ω has ζ = cω/2k.
inline SpringScene scene_of(const Pull& pull, double stiffness, double damping) {
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

/// The same where the damping ratio of the fastest oscillation is known.
inline SpringScene scene_of_zeta(const Pull& pull, double stiffness, double zeta) {
    const double root = std::sqrt(positive("stiffness", stiffness));
    SpringScene scene(DampedSpring<double>(root * std::sqrt(pull.most), zeta),
                      DampedSpring<double>(root * std::sqrt(pull.least), zeta), pull.found);
    scene.several = pull.several;
    scene.turns = pull.turns;
    return scene;
}

}  // namespace timestep
