#pragma once
/// \file
/// What a step costs, in units that do not depend on the machine (I12).

namespace timestep {

/// The work of one step.
struct Cost {
    int evaluations = 0;  ///< how often the force is evaluated
    int solves = 0;       ///< linear solves on a linear model; a nonlinear one needs several
};

}  // namespace timestep
