#pragma once
/// \file
/// Which method, what does it cost, will my simulation blow up, how far is it from the truth? For springs and for a
/// damper alone, what every method makes of them at a given step: predicted, without a single step of simulation (I13).

#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/stability_limit.hpp>

#include "which_method.hpp"

namespace timestep {

/// Every method that is advised on, in the order in which the course meets them, and so in each list of Advice.
inline constexpr auto spring_methods =
    std::tuple_cat(all_methods, std::tuple{semi_implicit_euler_new_damping}, verlet_methods);

/// The place of a method in that order. A method that is not on the list does not compile.
template <class Method>
inline constexpr std::size_t place_of = std::apply(
    [](const auto&... all) {
        static_assert((std::is_same_v<Method, std::remove_cvref_t<decltype(all)>> || ...), "no method to advise on");
        std::size_t place = 0;
        (void)((!std::is_same_v<Method, std::remove_cvref_t<decltype(all)>> && ++place) && ...);
        return place;
    },
    spring_methods);

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
double lightness(double mass, double arm, double inertia);

/// `springs` springs between the world and one body. All of them in one place, pulling one way, are
/// the fastest. At least there is the oscillation of one spring that pulls at the centre of mass,
/// and of three directions one in which a third of all of them pull.
Pull springs_on_body(double mass, double springs, double arm = 0, double inertia = 0);

/// Points of equal mass, each with `springs` springs to its neighbours: two in a chain, four in a
/// cloth. Two neighbours that swing against each other stretch a spring from both ends. At least
/// one pair does.
Pull springs_between(double mass, double springs);

/// One spring that holds two bodies together; `one` and `other` are their lightness() at its ends.
Pull hinge(double one_mass, double one, double other_mass, double other);

/// The scene of these springs, each with the damper `damping`, N·s/m, beside it: an oscillation of
/// ω has ζ = cω/2k.
SpringScene scene_of(const Pull& pull, double stiffness, double damping);

/// The same where the damping ratio of the fastest oscillation is known.
SpringScene scene_of_zeta(const Pull& pull, double stiffness, double zeta);

/// What one method makes of a spring. Numbers that mean nothing here are NaN.
struct Advice {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::string method;                  ///< its name
    Verdict verdict = Verdict::refused;  ///< will it blow up?
    std::string reason;                  ///< the formula that says so, with its numbers
    double longest_step = unknown;       ///< the longest stable step, s; infinite where there is no limit
    double growth_per_step = unknown;    ///< what a step multiplies the amplitude by in the long run
    double growth_per_second = unknown;  ///< the same for a second of game time
    double energy_ratio = unknown;       ///< the energy after a second over what it should be
    double energy_drift = unknown;       ///< that minus one
    double period_error = unknown;       ///< the period over the exact one, minus one
    double position_error =
        unknown;                  ///< farthest from the true place in the first period, over the start: see advise()
    double rate_error = unknown;  ///< how wrong the motion's frequency and decay are: see advise()
    double cost = unknown;        ///< force evaluations and solves in a second of game time
    double accurate_from = 0;     ///< where the first stretch of right steps begins, s: below roundoff is too much
    double accurate_step = 0;     ///< where it ends, s; 0: there is none
    double accurate_cost = 0;     ///< what that costs, evaluations and solves a second; 0 if there is none
    double ringing = 0;           ///< what a step multiplies the part by that rings, below −1/2; 0: none does
    double step = 0;              ///< the step that was asked about, s
    bool right = false;           ///< is that one stable and as near as wanted, and nothing rings?
};

/// Stable, and yet it keeps four times the energy that it should, twice the amplitude, while a
/// hundredth of the start is there to be seen.
bool lingers(const Advice& advice);

/// The verdict in words, and beside "stable" what is alarming all the same: stable is not right.
std::string told_verdict(const Advice& advice);

/// What every method of the course makes of the fastest oscillation of `scene`, which may be just
/// one DampedSpring, at steps of `h` seconds, in the order in which the course meets them. With
/// frames of uneven length `h` is the longest of them.
///
/// **The error that counts is the one that is seen**: let the spring go at rest, and compare the
/// positions after every step of the first period, 2π/ω, with the exact ones. The largest distance,
/// as a share of the start, is Advice::position_error. (Beyond ζ = 1 the time looked at is 2π over
/// the slow decay's rate; one step at least, and eight where fewer than three would fit.) Beyond ζ
/// = 5.1 the fast decay is hidden in these positions. If at least three steps `h` fit into 2π/q,
/// where q is the rate of that decay, a second start counts as well: the body is thrown from its
/// rest position. Advice::position_error is then the larger of the two errors; the second is that
/// of the velocity, relative to the throw's. A velocity that belongs half a step earlier, as
/// semi-implicit Euler's, moves the whole motion in time: that is seen, and it counts.
///
/// Growth, period and energy are those of the step's eigenvalues, in the long run. Of the motion
/// e^(μt) a step makes e^((ln λ / h) t), so |ln λ / h − μ| / |μ| is how wrong its rate is,
/// frequency and decay together: Advice::rate_error. Near ζ = 1 the two rates of a spring meet, and
/// tiny changes of it drive them far apart. There the step's motion is compared as a whole: it is
/// that of another spring, ω' and ζ', and the error is |ω' − ω|/ω and |ζ'ω' − ζω|/ω together
/// (beyond ζ = 1 the latter is |ζ'ω' − ζω|/(ζω)). The smaller of the two counts. In both errors
/// roundoff counts: in double, a step that changes the state only by a share δ is off by up to
/// 2⁻⁵³/δ.
///
/// `wanted` is how large the position error may be. A step is **right** if it is stable, the error
/// is no larger, and nothing rings. Told are whether the step `h` is, and the end of the first
/// stretch of right steps. Longer ones may be right again, by errors that happen to cancel; of
/// those only `h` itself is looked at. (A tether is judged right while it is taut.)
///
/// A stable method may still **ring**: a step multiplies a part that should decay by less than
/// −1/2, and it shakes from step to step. Then the advice says so.
///
/// A force evaluation and a solve are counted as equal in cost. Throws `std::invalid_argument`
/// where ω or h is not above zero and finite, where ωh is below 1e-12 (a step then changes nothing
/// but the last digits) or not finite, or `wanted` is not between 1e-8 and 0.5.
std::vector<Advice> advise(SpringScene scene, double h, double wanted = 0.01);

/// The longest step known to be right and no longer than `longest`, in seconds; 0 if there is none.
double best_step(const Advice& advice, double longest = std::numeric_limits<double>::infinity());

/// What the method costs a second at best_step().
double best_cost(const Advice& advice, double longest = std::numeric_limits<double>::infinity());

/// Of the methods that stay as near as wanted the one that does so at the least cost, with steps no
/// longer than `longest`; of equally cheap ones the one that stays nearer. Null where none does.
const Advice* cheapest(const std::vector<Advice>& all, double longest = std::numeric_limits<double>::infinity());

/// The advice on one method.
template <class Method>
const Advice& advice_on(const std::vector<Advice>& all, const Method&) {
    return all[place_of<Method>];
}

/// One method, and how many steps of it in the place of each step that was asked about.
struct Recommendation {
    const Choice* choice;  ///< the row of the list
    std::size_t place;     ///< of the method in spring_methods: that of the row, or another where that costs too much
    long substeps;         ///< 1: the step as it is; 0: none of up to a million does
    std::string method;    ///< its name
    std::string take;      ///< the row's words, or what of them is meant here
    std::string why;       ///< the same of the reason
    double position_error = std::numeric_limits<double>::quiet_NaN();  ///< at those substeps: see Advice
    double rate_error = std::numeric_limits<double>::quiet_NaN();      ///< at those substeps
    bool swept = false;  ///< are dampers swept there and back? Then both errors are those of all dampers at once
};

/// What of a spring in a game the numbers do not tell.
struct Goal {
    bool precise = false;     ///< has an accuracy been asked for?
    bool keeps_size = false;  ///< must an oscillation faster than the frame keep its size?
    double accuracy = 0.01;   ///< the one that advise() was asked about
};

/// The answer for steps of `h`, and the fewest substeps with which it is stable, does not ring, and
/// is as near as was asked for. `all` is what advise() says of the same, to the accuracy of `goal`.
/// Asked for an accuracy, it is the method that reaches it at the least cost, in whole substeps of
/// `h`.
Recommendation recommend(SpringScene scene, double h, const Goal& goal, const std::vector<Advice>& all);

/// What every method makes of a velocity that a damper alone slows down, v' = −rate v with `rate` =
/// c/m in 1/s, at steps of `h` seconds. Advice::position_error is that of the **velocity** here:
/// the largest error, over the velocity at the start, until 2π/rate. The exact step multiplies it
/// by e^(−h rate). Throws `std::invalid_argument` where the rate or the step is not above zero and
/// finite, their product is not from 1e-12 to 1e12, or `wanted` is not from 1e-8 to 0.5.
std::vector<Advice> advise_damper(double rate, double h, double wanted = 0.01);

/// The answer for a damper alone: down the list of which_method.hpp, or, asked for an accuracy, the
/// method that reaches it at the least cost in whole substeps of `h`.
Recommendation recommend_damper(double rate, double h, const Goal& goal, const std::vector<Advice>& all);

}  // namespace timestep
