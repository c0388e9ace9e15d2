// Chapter 1, exercise 3: the order, when nobody knows the exact value
//
// You wrote a solver for your game and want to know its order. There is no exact solution to
// compare with. So you compute the same number three times: with the step $h$, with $h/2$ and
// with $h/4$. The error of each result is $C$ times its step to the power $p$, and you know
// neither $C$ nor the exact value.
//
//   coarse       the result with the step $h$
//   middle       the result with the step $h/2$
//   fine         the result with the step $h/4$
//   returns      the order $p$; it need not be a whole number, and is below zero where the error
//                grows as the step shrinks (rounding errors do)
//
// The results may have any unit and any sign, and may rise or fall. They come one after the other:
// middle always lies between coarse and fine, and no two of them are equal.
//
// Example: `order_of_results(1.75, 1.1875, 1.046875)` is 2. The exact value was 1, and the errors
// are 0.75, a quarter of that and a sixteenth.
//
// What is checked: the order of results whose error is exactly $C$ times a power of the step,
// whole or not, above zero or below; the order stays the same when the results are shifted,
// scaled or mirrored; the differences of this chapter, on a smooth function, show the orders that
// the chapter tells.

#include "exercise.hpp"

double order_of_results(double coarse, double middle, double fine) {
    // [answer]
    // The exact value drops out of each difference: C hᵖ (1 − 2⁻ᵖ), and the same with h/2.
    return std::log2((coarse - middle) / (middle - fine));
    // [answer]
}
