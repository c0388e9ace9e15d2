#pragma once
/// \file
/// Will it blow up? The verdicts of the command advise, and what must be known of a spring's scene
/// for one (I13).

#include <cmath>
#include <string>

#include "advise_multipliers.hpp"
#include <timestep/stability_limit.hpp>

namespace timestep {

/// The springs of a scene, as their fastest oscillation sees them. Of many springs only bounds of
/// that swing are known: then `least` is slower than `fastest`, each with its own damping ratio.
/// Springs with dampers beside them swing slower by other patterns, with less damping; where the
/// fastest oscillation is stable those are, too.
struct SpringScene {
    DampedSpring<double> fastest;  ///< the fastest oscillation is this one at most
    DampedSpring<double> least;    ///< and this one at least
    bool only_pulls = false;       ///< a tether: it lets go when it is slack
    bool is_net = false;           ///< many springs, between many masses
    bool is_joint = false;         ///< a hinge: one place of two bodies, held together
    bool several = false;          ///< several springs, each with the damper beside it
    bool turns = false;            ///< a spring takes hold off a centre of mass, so that it turns a body
    bool kicks = false;            ///< do impulses come between the steps?
    double shortest_frame = 0;     ///< s; 0: every step is as long as the last
    double longest_frame = 0;      ///< s
    std::string found{};           ///< how the fastest oscillation was found, in a line
    bool thrown = false;           ///< does the velocity after a throw count, too? advise() and recommend() find out

    /// One spring, of which all is known.
    SpringScene(const DampedSpring<double>& spring) : fastest(spring), least(spring) {}
    /// A fastest oscillation between two bounds.
    SpringScene(const DampedSpring<double>& fastest_, const DampedSpring<double>& least_, const std::string& found_)
        : fastest(fastest_), least(least_), found(found_) {}

    bool varying() const { return shortest_frame < longest_frame; }  ///< are frames of uneven length?
    bool bounded() const { return least.omega < fastest.omega; }     ///< are only bounds known?
};

/// \cond
namespace detail {

struct Said {
    Verdict verdict;
    std::string reason;
};

// Why a constant step is stable or not, for people.
inline std::string reason(const StabilityLimit& limit, double s) {
    if (!std::isfinite(limit.value)) return "stable for every step";
    const int digits = number(s) == number(limit.value) ? 7 : 4;  // as many as tell the two apart
    const std::string left = number(s, digits), right = number(limit.value, digits);
    const std::string words = limit.formula, link = words.starts_with("the ") ? ", " : " = ";
    const std::string formula = right == words ? "" : link + words;
    if (left == right) return "ωh = " + left + formula + ", the limit itself";
    return "ωh = " + left + (s < limit.value ? " < " : " > ") + right + formula;
}

// A constant step. `high` is the limit for the fastest oscillation that can be, `low` for the
// slowest that the fastest one can be. By each method's formula a slower swing with less damping is
// stable where a faster one with more, in proportion, is: no limit rises faster than ζ does.
inline Said constant_step(const SpringScene& scene, double h, const StabilityLimit& high, const StabilityLimit& low) {
    const double s = scene.fastest.omega * h, least = scene.least.omega * h;
    const Verdict at_most = verdict(s, high.value), at_least = verdict(least, low.value);
    if (at_most == Verdict::stable || !scene.bounded()) return {at_most, reason(high, s)};
    if (at_least == Verdict::grows) return {Verdict::grows, reason(low, least) + ", at least"};
    return {Verdict::not_proven,
            "ωh is " + number(least) + " to " + number(s) + ", and " + number(high.value) + " the limit"};
}

// Several dampers at the new velocity, one after another there and back with a root of each
// division, or all in one system of equations. Either way v₂ = P (v₁ − h A x₁) with P symmetric, 0
// < P ≤ 1, masses as the measure. An eigenvalue λ of the step solves (1 + c) λ² − (2 + c − s) λ + 1
// = 0 with c ≥ 0 from P⁻¹ − 1 and s from h²A, both taken at its eigenvector. Up to s = 4, ωh = 2
// without the dampers, |λ| ≤ 1. Beyond it `high` and `low` are the limits of one system of
// equations.
inline Said several_dampers(const SpringScene& scene, double h, const StabilityLimit& high, const StabilityLimit& low) {
    const double s = scene.fastest.omega * h, least = scene.least.omega * h;
    if (verdict(s, 2) == Verdict::stable)
        return {Verdict::stable, "ωh = " + number(s) + " < 2, dampers there and back or all at once"};
    if (verdict(least, low.value) == Verdict::grows)
        return {Verdict::grows, reason(low, least) + ", at least, dampers all at once"};
    return {Verdict::not_proven,
            "ωh = " + number(s) + " at most: proven below 2; with all dampers at once below " + number(high.value)};
}

// A tether that lets go and takes hold between two steps can be stretched, when it takes hold, by
// more than its speed ever paid for. Implicit Euler alone has a proof: between points the force is
// the slope of a potential that is convex, slack or taut, and by each of its steps the energy
// falls. Off a centre of mass the potential is not convex in the body's angle, and a step of
// implicit Euler may gain.
inline Said tether(const Said& taut, bool implicit_euler) {
    if (implicit_euler) return {Verdict::stable, "stable for every step, slack or taut"};
    if (taut.verdict != Verdict::stable) return {taut.verdict, "taut: " + taut.reason};
    return {Verdict::not_proven, "taut: " + taut.reason + "; each time it goes taut, it may gain"};
}

}  // namespace detail
/// \endcond

}  // namespace timestep
