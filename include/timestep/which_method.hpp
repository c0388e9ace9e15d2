#pragma once
/// \file
/// Which method? The course's one answer to that question: the page \ref which_method, the short answers of
/// chapters 3 to 8 and `./course advise` are made from this list, so none of them can say something else (I13).

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace timestep {

/// Up to this ωh a swing looks alive by semi-implicit Euler: six steps a swing.
inline constexpr double alive_turn = 1;
/// From this damping ratio on an implicit method is right to a percent at less cost than Runge–Kutta 4.
inline constexpr double stiff_decay = 2;
/// Up to this h|ω|, in radians a step, ball and remainder 4 points where it should: chapter 8 has thrown
/// bodies about every axis to find it.
inline constexpr double fair_turn = 0.25;
/// Up to this h|ω| the half-step Jacobian is calm, as long as neither step nor spin is changed from outside.
inline constexpr double calm_turn = 0.5;
/// Two moments that differ by no more than this share are better declared equal.
inline constexpr double nearly_equal = 0.05;
/// From so many bodies on it pays to step them in lanes.
inline constexpr int many_bodies = 1000;

/// One row of the answer.
struct Choice {
    std::string name;    ///< what pages and programs call it
    std::string have;    ///< what you have
    std::string take;    ///< what to take; bold, between two pairs of asterisks, is the method
    std::string why;     ///< what it gives and what it costs, in a sentence
    std::string where;   ///< the section of the course that has measured it
    std::string method;  ///< its name in the library; empty where the answer is none of one method
};

/// \cond
namespace detail {
inline std::string plain(double value) {  // 0.25 and not 0.250000
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}
}  // namespace detail
/// \endcond

/// All answers: first those of what swings and is pulled, then those of what turns.
inline const std::vector<Choice>& choices() {
    using detail::plain;
    static const std::string alive = plain(alive_turn), fair = plain(fair_turn), calm = plain(calm_turn);
    static const std::vector<Choice> all{
        {"swing", "ωh at most " + alive + ", a constant step: most of a game",
         "**semi-implicit Euler**, with the damping at the new velocity",
         "one force a step; its energy swings and does not drift, and its division survives any damper", "ch3_question",
         "semi-implicit Euler, new damping"},
        {"positions", "points that are pushed about, forces of the position alone: ropes, cloth",
         "**Verlet**; its twin velocity Verlet where you want a velocity", "no velocity to keep in step with the push",
         "ch4_question", "Verlet"},
        {"smooth", "a smooth motion, right to one percent or better", "**Runge–Kutta 4**, with long steps",
         "four forces a step, and an error that falls with the fourth power of the step", "ch7_pictures", "Runge-Kutta 4"},
        {"bumps", "things that bump into each other", "**semi-implicit Euler**, with shorter steps where it shows",
         "a bounce takes the order of the others away", "ch7_pictures", "semi-implicit Euler, new damping"},
        {"uneven", "frames of uneven length", "a constant step, by chapter 2's game loop; where that cannot be, **implicit Euler**",
         "limits hold for a constant step; implicit Euler loses energy by every step, however they follow each other",
         "ch2_turns", "implicit Euler"},
        {"pull", "a stiff pull to a target, a decay", "**implicit Euler**", "the decay dies, as it should", "ch6_stiff",
         "implicit Euler"},
        {"smooth_pull", "the same, right to one percent or better, ζ at least " + plain(stiff_decay), "**BDF2**, restarted after each kick",
         "its steps follow the slow part, the fast one dies", "ch6_stiff", "BDF2"},
        {"unseen", "a swing faster than the frame, which nobody must see", "**BDF2**, restarted after each kick",
         "the fast part dies and the slow one keeps its size", "ch6_kicks", "BDF2"},
        {"keeps_size", "a swing faster than the frame that must keep its size", "**implicit midpoint**, with a constant step",
         "its energy stays; of a decay it makes ringing", "ch6_stiff", "implicit midpoint"},
        {"jumps", "creeping and sudden jumps", "a step that adapts", "one length does not fit both", "ch6_question", ""},
        {"typed", "numbers that others type", "checks where models and runs are made", "no method survives everything",
         "ch6_extremes", ""},
        {"ball", "a body with three equal moments: a ball, a cube", "**nothing**: leave the gyroscopic torque out",
         "it is zero", "ch5_inertia", "dropped"},
        {"symmetric", "two moments within " + plain(100 * nearly_equal) + " % of each other: a spear, a wheel",
         "**declare them equal**: `SymmetricInertia`", "one turn is the exact step, it costs little and adds nothing",
         "ch5_passive", "symmetric, exact"},
        {"free", "a body that flies freely, h|ω| at most " + fair, "**ball and remainder 4**",
         "|L| stays, the energy is bounded, and the body points where it should", "ch8_work", "ball and remainder 4"},
        {"free_fast", "the same, faster", "**ball and remainder 4**, in so many substeps that each turns by " + fair + " at most",
         "what is safe at long steps is not right at them", "ch8_safe", "ball and remainder 4"},
        {"contacts", "a body that touches others, in an engine that asks for a new ω", "the **passive step**",
         "for no body, no spin and no step does it add energy itself; it slows spins down", "ch8_contacts", "passive"},
        {"many", "bodies by the thousand, h|ω| at most " + calm, "the **half-step Jacobian** in lanes; the faster ones by passive",
         "several bodies in the time of one", "ch8_many", "half-step Jacobian"},
        {"energy", "the energy kept, whatever else", "**Cayley**", "exactly, for any step; |L| creeps", "ch8_cayley", "Cayley"},
    };
    return all;
}

/// The answer of this name. Throws `std::out_of_range` where there is none.
inline const Choice& choice(std::string_view name) {
    for (const Choice& each : choices())
        if (each.name == name) return each;
    throw std::out_of_range("there is no answer \"" + std::string(name) + "\" to which method");
}

/// What must be known of a spring to choose.
struct SpringQuestion {
    double turn;              ///< ωh of the fastest swing, rad a step
    double zeta = 0;          ///< its damping ratio
    bool even = true;         ///< is the step constant?
    bool precise = false;     ///< is an error of a percent too much?
    bool keeps_size = false;  ///< must a swing faster than the frame be kept?
};

/// The way down the tree for a spring. A step of an implicit method costs a force and a solve, as much as two of
/// semi-implicit Euler: so up to twice the ωh at which that one looks alive, two substeps of it are the answer.
inline const Choice& choose(const SpringQuestion& spring) {
    if (!spring.even) return choice("uneven");
    if (spring.precise) return choice(spring.zeta < stiff_decay ? "smooth" : "smooth_pull");
    if (spring.turn <= 2 * alive_turn) return choice("swing");
    if (spring.zeta >= 1) return choice("pull");
    return choice(spring.keeps_size ? "keeps_size" : "unseen");
}

/// What must be known of a body to choose.
struct BodyQuestion {
    std::array<double, 3> moments;  ///< in any order, kg m²
    double turn;                    ///< h|ω|, rad a step
    bool contacts = false;          ///< does it touch others?
    long count = 1;                 ///< how many of them there are
    bool even = true;               ///< is the step constant?
};

/// The way down the tree for a body that turns.
inline const Choice& choose(const BodyQuestion& body) {
    auto [least, middle, most] = body.moments;
    if (least > middle) std::swap(least, middle);
    if (middle > most) std::swap(middle, most);
    if (least > middle) std::swap(least, middle);
    if (least == most) return choice("ball");
    if (middle - least <= nearly_equal * middle || most - middle <= nearly_equal * most) return choice("symmetric");
    if (body.contacts) return choice("contacts");
    if (body.count >= many_bodies && body.even && body.turn <= calm_turn) return choice("many");
    return choice(body.turn <= fair_turn ? "free" : "free_fast");
}

}  // namespace timestep
