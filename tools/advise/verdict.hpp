#pragma once
/// \file
/// Will it blow up, and why: for a constant step, several dampers, a tether, and frames of uneven length, where
/// products of a step's matrices decide, one matrix for each length.

#include "method_on_spring.hpp"

namespace timestep {

/// A verdict, and the formula behind it.
struct Reason {
    Verdict verdict;
    std::string reason;
};

/// A constant step.
Reason constant_step(const SpringScene& scene, double h, const StabilityLimit& high, const StabilityLimit& low);

/// Several dampers at the new velocity, one after another there and back, or all in one system of equations.
Reason several_dampers(const SpringScene& scene, double h, const StabilityLimit& high, const StabilityLimit& low);

/// A tether, from what is said of it while it is taut.
Reason tether(const Reason& taut, bool implicit_euler);

/// How fast a state grows per step: the mean of the logarithm, and how well it is known.
struct Growth {
    double mean, deviation;
};

/// The steps of all lengths, in double.
std::vector<StepMatrix<double>> steps_of(const MatrixOf& matrix, double shortest, double longest);

/// The growth with frames at random: of any steps, and of steps that commute.
Growth random_products(const std::vector<StepMatrix<double>>& steps);
Growth mean_growth(const std::vector<StepMatrix<double>>& steps, double zeta);

/// Frames between two lengths, as ωh.
Reason varying_steps(bool steps_commute, const StabilityLimit& limit, double shortest, double longest,
                     const std::vector<StepMatrix<double>>& steps, const Growth& growth);

/// The largest distance from the true place in the first period, with frames at random.
double random_position_error(const MatrixOf& matrix, const std::function<double(long double)>& constant,
                             const DampedSpring<long double>& spring, double shortest, double longest);

}  // namespace timestep
