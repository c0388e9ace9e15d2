// Chapter 7, exercise 3: which of two solvers is faster, on a busy machine
//
// You have two solvers, A and B, and want to know how many times as long A takes. You time them in
// turns: each round times A, then B, then a loop that does nothing. The empty loop tells what the
// loop and the clock cost; that much is also in the times of A and of B. But the machine is busy:
// now and then other programs are let in, and what runs just then takes longer. Nothing ever takes
// less time than it needs.
//
//   rounds    the times of each round, `{A, B, empty loop}`, in seconds (1e-9 to 1e3); one round
//             or more. All but one of A's times may be disturbed, all but one of B's, and all but
//             one of the empty loop's: those left may be in three different rounds
//   returns   how many times as long A takes as B, both without what the loop and the clock cost
//
// Where nothing disturbs, A and B take longer than the empty loop, by a thousandth of it at least.
//
// Example: `fair_ratio({{5, 4, 1}, {7, 3, 1}, {9, 4, 2}})` is 2: A takes 5 - 1 seconds and B 3 -
// 1.
//
// What is checked: one round; a solver against itself; disturbances of every round but one, in each
// column, change nothing, be they short, long or of a whole round; the order of the rounds; A and B
// swapped; what is in all times, and cancels; other units; three solvers.

#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    // [answer]
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    const auto [a, b, empty] = fastest;
    return (a - empty) / (b - empty);
    // [answer]
}
