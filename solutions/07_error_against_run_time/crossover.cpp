// Chapter 7, exercise 4: where two lines of the diagram cross
//
// Your editor bakes the flights of cut-scenes, and your game flies live. Two methods are at hand:
// A of order $p$, and B of a higher order $q$, whose step costs more. You have measured one run
// of each, as long as each other in the game's time, with whatever steps. Draw error against run
// time with logarithms on both axes, a work-precision diagram: each method is a straight line.
// Above some error A is faster, below it is B. Where do the lines cross?
//
//   a         `{seconds, error}` of the run of A: time of the processor (1e-12 to 1e6 s), and how
//             far off it was (1e-15 to 100 m)
//   p         order of A, 1 to 3
//   b         the same of the run of B
//   q         order of B, above $p$ and at most 4
//   returns   `{seconds, error}` where both methods need the same time for the same error
//
// The error of a run is $C$ h^order, and its time is its number of steps, times what a step
// costs. Any number of steps is allowed, also a part of one, and the crossing may lie far from
// the points.
//
// Example: `crossover({1, 0.04}, 1, {8, 0.0025}, 2)` is `{4, 0.01}`. If A takes four times as
// long it has a quarter of its error, and if B takes half as long it has four times its own.
//
// What is checked: two points that are the same; at the crossing both methods need the time you
// return, for the error you return; who is faster on either side; other runs of the same methods;
// steps that cost more; other units.

#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // [answer]
    // For an error E method A takes a[0] (a[1]/E)^(1/p): so long for an error of 1 m, over a root
    // of E.
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    const double error = std::pow(a_of_1 / b_of_1, 1 / (1.0 / p - 1.0 / q));
    return {a_of_1 / std::pow(error, 1.0 / p), error};
    // [answer]
}
