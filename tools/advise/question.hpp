#pragma once
/// \file
/// ./course advise: what is asked, and what is told.

#include <optional>
#include <string>
#include <vector>

namespace timestep {

/// What is asked: a spring or a spinning body, and a step. What was not given is empty.
struct Question {
    std::optional<double> omega, stiffness, mass, damping, zeta;  ///< rad/s, N/m, kg, N s/m, no unit
    std::optional<double> step, rate;                             ///< s, 1/s
    std::vector<double> inertia, spin;                            ///< kg m², rad/s
    std::optional<double> accuracy;  ///< percent; not given: nothing asked, and 1 in the table
    std::vector<double> frames;      ///< the shortest and the longest, s, where they differ

    // Of a body.
    std::optional<double> count;  ///< of bodies like this one; 1 where not given
    bool contacts = false;        ///< does it touch others?
    bool callback = false;        ///< and can it only be changed before the engine's step?

    // More kinds of springs than one.
    std::string kind = "spring";                                 ///< or chain, cloth, tether, hinge
    std::optional<double> springs, arm, turning;                 ///< how many, m, kg m²
    std::optional<double> other_mass, other_arm, other_turning;  ///< of a hinge's other body
    bool kicks = false, keep_size = false;                       ///< impulses; a fast oscillation that is to stay
};

/// What is told: text as it stands, and paragraphs, to be broken into lines. Bold stands between pairs of asterisks.
struct Told {
    std::string text;
    bool paragraph;
};

/// The answer for people, or as JSON. Throws `std::invalid_argument` where the question makes no sense.
std::vector<Told> answer(const Question& question, bool json);

}  // namespace timestep
