#pragma once
/// \file
/// Which method? The one list of answers (I13). The page \ref which_method, the short answers of
/// chapters 3 to 8 and the command `advise` are made from it, so none of them can say something
/// else.

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace timestep {

/// Up to this ωh an oscillation looks alive under semi-implicit Euler: six steps per period.
inline constexpr double alive_turn = 1;
/// Up to this ωh semi-implicit Euler keeps the energy of a pendulum in the spring's band, let go
/// anywhere up to 3.1 rad, as chapter 3 has measured. At twice that one let go near its top goes
/// over it.
inline constexpr double pendulum_turn = 0.5;
/// Up to this ωh, when taut, we have seen no tether gain a quarter of its energy by semi-implicit
/// Euler, in 100,000 steps. By twice that one throw in five does, by four times that nine in ten.
/// Nothing proves that none will.
inline constexpr double tether_turn = 0.125;
/// From this damping ratio on an implicit method is right to a percent at less cost than
/// Runge–Kutta 4.
inline constexpr double stiff_decay = 2;
/// Up to this ωh and ζωh Runge–Kutta 4 is right to one percent of the amplitude for four periods, ζ
/// up to stiff_decay.
inline constexpr double fine_turn = 0.45;
/// Up to this ωh, over ζ, BDF2 is right to one percent of where a spring of ζ from stiff_decay on
/// is let go.
inline constexpr double fine_pull = 0.2;
/// From this ζωh on a damper ends an oscillation within a frame or so: it is a decay.
inline constexpr double ended_swing = 2;
/// Up to this h|ω|, in radians a step, ball and remainder 4 points where it should: chapter 8 has
/// thrown bodies about every axis to find it.
inline constexpr double fair_turn = 0.25;
/// The same for Runge–Kutta 4, whose errors do not ask whether the steps are equally long.
inline constexpr double fair_uneven_turn = 1.0 / 12;
/// Up to this h|ω| the half-step Jacobian is calm, as long as neither step nor spin is changed from
/// outside.
inline constexpr double calm_turn = 0.5;
/// Up to so many substeps a frame an explicit step is taken for a net before a factorisation:
/// chapter 6 measures where the two cost the same, which was at about as many for a small cloth,
/// and at more for larger ones.
inline constexpr long net_substeps = 100;
/// Bullet's own Newton step, in `float`, is off where the product of the moments, (kg m²)³, is at
/// most this.
inline constexpr double bullet_guard = static_cast<double>(std::numeric_limits<float>::epsilon());
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

/// All answers: first those of what swings and is pulled, then those of what turns. Each list is
/// read from its top: the first that fits is the answer.
const std::vector<Choice>& choices();

/// The answer of this name. Throws `std::invalid_argument` where there is none.
const Choice& choice(std::string_view name);

/// What must be known of a spring to choose.
struct SpringQuestion {
    double turn;              ///< ωh of the fastest oscillation, rad a step
    double zeta = 0;          ///< its damping ratio
    bool even = true;         ///< is the step constant?
    bool precise = false;     ///< is an error of a percent too much?
    bool keeps_size = false;  ///< must an oscillation faster than the frame be kept?
    bool only_pulls = false;  ///< is it a tether, which goes slack?
    bool is_net = false;      ///< are there many springs, between many masses?
    bool is_joint = false;    ///< is it a joint between two bodies?
};

/// The way down the tree for a spring.
const Choice& choose(const SpringQuestion& spring);

/// What must be known of a body to choose.
struct BodyQuestion {
    std::array<double, 3> moments;  ///< in any order, kg m²
    double turn;                    ///< h|ω|, rad a step
    bool contacts = false;          ///< does it touch others?
    long count = 1;                 ///< how many of them there are
    bool even = true;               ///< is the step constant?
    bool callback = false;          ///< can only ω be changed, and only before the engine's step?
    bool is_ball = false;           ///< are the three moments so near each other that nobody sees the difference?
    bool is_symmetric = false;      ///< are two? recommend() asks both of the body and its spin
};

/// The way down the tree for a body that turns.
const Choice& choose(const BodyQuestion& body);

}  // namespace timestep
