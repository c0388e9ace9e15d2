// Chapter 2, exercise 7: the first step that differs
//
// Two machines have played the same replay, and each has recorded one number a step: the height of
// a ball, say. Find the first step at which the recordings differ in their bits.
//
// Bits count, not values: 0 and -0 differ, and two numbers differ if only their last bit does. The
// same NaN on both machines is no difference. (Every NaN that is drawn has the same bits.) A
// recording that ends early differs at the first step that it lacks. Two runs that parted may meet
// again later.
//
//   here     what this machine has recorded, step by step; it may be empty
//   there    what the other one has
//   returns  the number of the first step that differs, counted from 0; -1 if none does
//
// Example: (1, 2, 3) and (1, 4, 3) differ first at step 1; (1, 2) and (1, 2, 3) at step 2; (1, 2)
// and (1, 2) nowhere: -1.
//
// What is checked: equal recordings; one difference, several, and ones that vanish again; the last
// bit of large and tiny numbers; zeros of two signs, NaN and infinity; recordings that end early;
// an hour at 60 steps a second.

#include "exercise.hpp"

#include <bit>
#include <cstdint>

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    return not_started;  // your answer
}
