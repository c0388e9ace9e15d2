#pragma once
/// \file
/// Which solver for my spinning body? Whether each can ever add energy, what each makes of the very throw that was
/// asked about, and which one to take (N51, I13).

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <timestep/body_solvers.hpp>
#include <timestep/body_throw.hpp>

#include "which_method.hpp"

namespace timestep {

/// A step whose energy rises by so much is no roundoff.
inline constexpr double more_than_roundoff = 1e-12;

/// The direction of the spin in which a step gains most, of those that were searched.
struct Worst {
    double gain = 0;
    Vector3<double> direction = Vector3<double>::UnitX();
};
/// Ends the search at a gain above `enough`.
Worst worst_direction(const std::function<double(const Vector3<double>&)>& gain_towards,
                      double enough = std::numeric_limits<double>::infinity());

/// The longest step of the talk's iteration with which no direction gains, s.
double longest_safe_step(const PrincipalInertia<double>& inertia, double spin);

/// From which step on its gain has no bound, s.
double unbounded_step(const PrincipalInertia<double>& inertia, double spin);

/// Is there no gyroscopic torque: are all moments equal?
bool no_torque(const PrincipalInertia<double>& inertia);

/// Can a solver ever add energy to a body that is left alone, whatever the direction of its spin?
enum class AddsEnergy {
    never,              ///< not in any number of steps
    bounded,            ///< it may, but never has the body more than so many times its first
    one_step_can,       ///< in some direction one step does; how far many of them get is not known
    too_close_to_call,  ///< within 0.1 % of the limit, or no more than roundoff
};

/// The answer in words.
const char* words(AddsEnergy answer);

/// What one solver can make of a spinning body.
struct BodyAdvice {
    std::string method;                   ///< its name
    AddsEnergy adds = AddsEnergy::never;  ///< can it ever add energy?
    double bound = 1;                     ///< times its first energy, and never more; infinite where no bound is known
    std::string reason;                   ///< the formula that says so, with its numbers
    double worst_gain = 1;                ///< where one step can: what the worst one found multiplies the energy by
    Vector3<double> worst_spin = Vector3<double>::Zero();  ///< the spin that gains it, rad/s in body coordinates
    double longest_step = std::numeric_limits<double>::infinity();  ///< up to which that verdict is no worse, s;
                                                                    ///< 0: every step adds
    BodyPrice price;                                                ///< what a step computes
    Thrown thrown;                                                  ///< what the throw that was asked about came to
};

/// A way to turn a free body, its type forgotten.
struct BodySolver {
    const char* name;
    BodyPrice price;
    /// Is a body that spins with `spin` rad/s, in any direction, ever given energy? All but the throw. `even`: are all
    /// steps equally long?
    std::function<BodyAdvice(const PrincipalInertia<double>& inertia, double spin, double h, bool even)> judge;
    /// See throw_body().
    std::function<Thrown(const PrincipalInertia<double>& inertia, const Vector3<double>& omega, const Frames& frames,
                         double seconds, long most_steps)>
        throw_body;
    /// The energy after one step of a second over that before it.
    std::function<double(const PrincipalInertia<double>& inertia, const Vector3<double>& omega)> gain;
};

/// So many steps of a throw are watched.
inline constexpr long most_thrown_steps = 60'000;

/// All of them, in the order in which the course meets them.
const std::vector<BodySolver>& body_solvers();

/// The one of this name. Throws `std::invalid_argument` where there is none.
const BodySolver& body_solver(std::string_view name);

/// What every solver of chapters 5 and 8 makes of a body that spins with `omega`, rad/s in its own
/// axes, in frames of these lengths. The verdict is for any direction of a spin so fast, and for
/// steps as long as the longest; the throw is of `omega` itself, tilted as as_thrown() has it.
///
/// Throws `std::invalid_argument` where the spin is not above zero and finite, or it or its product
/// with a step is above 1e50: some of the solvers' products would overflow.
std::vector<BodyAdvice> advise_body(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                                    const Frames& frames);

/// Which one to take.
struct BodyRecommendation {
    Choice choice;           ///< the answer of which_method.hpp
    long long substeps = 1;  ///< in so many of them a frame
};

/// The recommendation for this body, spun with `omega` (rad/s, in the body's axes). Throws
/// `std::invalid_argument` if the spin is not above zero and finite, or so fast that a free body
/// would need more than 1e9 substeps.
BodyRecommendation recommend(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                             const Frames& frames, bool contacts = false, long count = 1, bool callback = false);

}  // namespace timestep
