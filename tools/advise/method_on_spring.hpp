#pragma once
/// \file
/// A method on one damped spring, its type forgotten: what is said of it is compiled once for all methods.

#include <functional>
#include <vector>

#include <timestep/multipliers.hpp>
#include <timestep/stability_limit.hpp>

#include "advise.hpp"

namespace timestep {

using detail::Complex, detail::exact_rate;
using MatrixOf = std::function<StepMatrix<long double>(long double s)>;

/// A method on one spring.
struct MethodOnSpring {
    const char* name;
    int work;  // evaluations and solves in a step
    bool takes_damping;
    bool steps_commute;   // steps of all lengths are functions of one matrix
    bool two_steps;       // it takes the last two states for one curve
    bool implicit_euler;  // the one with a proof for tethers
    bool new_damping;     // semi-implicit Euler with the damping at the new velocity
    StabilityLimit limit,
        least_limit;         // for the fastest oscillation, and for the slowest that it can be
    StabilityLimit at_once;  // the first of them where all dampers are solved for at once
    std::function<std::vector<Complex>(long double s)> multipliers;
    std::function<double(long double s)> position_error;
    std::function<double(long double s)> velocity_error;  // after a throw, until the fast decay is over
    MatrixOf matrix;                                      // of a step that is not like the one before
};

/// Every method, in the order of spring_methods, for the damping ratios of the fastest oscillation and of the slowest
/// that it can be. `several`: several dampers. `thrown`: the start that counts besides, see advise().
std::vector<MethodOnSpring> methods_on_spring(double zeta, double least_zeta, bool several = false,
                                              bool thrown = false);

/// One of them.
template <class Method>
MethodOnSpring on_spring(const Method&, double zeta, double least_zeta, bool several = false, bool thrown = false) {
    return methods_on_spring(zeta, least_zeta, several, thrown)[place_of<Method>];
}

/// What a step changes is rounded, in double: where it is a small share of the state, as in a slow decay at a short
/// step, up to 2⁻⁵³ over that share is lost, and at last the whole.
constexpr long double rounded = 0x1p-53L;

/// What rings: a part that a step turns about and keeps a good deal of. It shakes from frame to frame, which no spring
/// does, and the rate of the slow part knows nothing of it. The bound is −1/2: there seven steps leave 1 % of it, which
/// at 60 Hz is over in a ninth of a second and hardly seen. Farther down it soon takes seconds.
constexpr long double rings_below = -0.5L;

/// Beyond this damping ratio the fast of the two decays is less than a hundredth of the motion of a spring that is let
/// go at rest, p/(q − p) with the rates p and q: its positions do not show what becomes of a velocity.
inline constexpr double hidden_decay = 5.1;

/// Is the fast decay hidden in the positions but visible after a throw, with at least three steps in its 2π/q? (If
/// roundoff swallows the slow motion, no step is right anyway.)
bool thrown_counts(double zeta, double s);

/// How wrong frequency and decay are.
double rate_error(const std::vector<Complex>& all, long double zeta, long double s);

/// The most negative multiplier that rings; 0 where none does.
long double ringing(const std::vector<Complex>& all, long double zeta, long double s);

/// Steps s = ωh, from the shortest to the longest; zeros where there is none.
struct StepRange {
    double from = 0, to = 0;
};

/// The first range of steps that are right: stable, as near as wanted, and free of ringing.
StepRange first_right(const MethodOnSpring& method, double zeta, double wanted);

/// What one method makes of a scene.
Advice advise(const MethodOnSpring& method, const SpringScene& scene, double h, double wanted);

/// The same without the range of right steps.
Advice at_step(const MethodOnSpring& method, const SpringScene& scene, double h, double wanted);

/// The advice on a method that does not step a damper.
Advice refused(const MethodOnSpring& method);

/// What a motion becomes in a second if a step of `h` adds `growth` to the logarithm of its size, and the truth adds
/// `rate` a second: fills that into `advice`.
void tell_growth(Advice& advice, long double growth, double h, long double rate);

/// Why `value` is stable or not beside its limit; `quantity` is its name.
std::string limit_reason(const std::string& quantity, double value, const StabilityLimit& limit);

/// Where from `low`, which is good, to `high` it ceases to be: by bisection.
double last_good(const std::function<bool(double)>& good, double low, double high);

/// So many steps of `longest` or less fit into `step`; 0: more than most_substeps.
long pieces(double step, double longest);
inline constexpr long most_substeps = 1'000'000;

/// The fewest substeps with which a method is right, and what they cost a second; 0 where none is.
struct Right {
    std::size_t place;
    long substeps = 0;
    double cost = std::numeric_limits<double>::infinity();
};

/// That of `all[place]`, in whole substeps of `h`, at least `least` of them; 0: none are enough.
Right right_steps(const std::vector<Advice>& all, std::size_t place, double h, long least = 1);

/// Calls `visit(method)` for every method.
template <class Visit>
void for_each_spring_method(const Visit& visit) {
    std::apply([&](const auto&... method) { (visit(method), ...); }, spring_methods);
}

/// What steps a method where the length of the step changes: BDF2 begins anew, with implicit midpoint.
template <class Method>
const auto& when_step_changes(const Method& method) {
    return method;
}
inline const auto& when_step_changes(const Bdf2&) { return implicit_midpoint; }

/// The place in spring_methods of the method that an answer names. Throws `std::invalid_argument` where it names none.
std::size_t place_of_choice(const Choice& choice);

/// A number for people.
std::string number(double value, int digits = 4);

}  // namespace timestep
