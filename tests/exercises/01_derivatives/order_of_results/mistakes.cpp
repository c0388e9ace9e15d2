#include "exercise.hpp"

// Says: The finest result is taken for the exact value. But it has an error of its own, which is not small
//       beside that of the middle one.
// Hint: With order one, the finest result has half the error of the middle one. Compare differences that are
//       made alike: each of two neighbours.
namespace finest_is_exact {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((coarse - fine) / (middle - fine));
}

}  // namespace finest_is_exact

// Says: This compares the results themselves, as if they were errors. It is right only where the exact value
//       is zero.
// Hint: Add 1000 to all three results: the order must stay as it is. What can you form of them that does not
//       change?
namespace values {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2(std::fabs(coarse / middle));
}

}  // namespace values

// Says: This is how many times the error shrinks when the step is halved: 2 for order one, 4 for order two,
//       8 for order three.
// Hint: You want the power to which 2 has to be raised to give that number.
namespace ratio {

double order_of_results(double coarse, double middle, double fine) {
    return (coarse - middle) / (middle - fine);
}

}  // namespace ratio

// Says: The natural logarithm of the ratio. Order one would come out as 0.69.
// Hint: The step is divided by two each time, not by e. The logarithm must fit.
namespace natural_logarithm {

double order_of_results(double coarse, double middle, double fine) {
    return std::log((coarse - middle) / (middle - fine));
}

}  // namespace natural_logarithm

// Says: The order has the wrong sign, as if the error grew with a smaller step: does the ratio stand upside down,
//       or is there a minus too many, as in the logarithm of 1/2?
// Hint: With order one the first difference is twice the second. Follow these two numbers through your formula:
//       where does the minus come in?
namespace upside_down {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((middle - fine) / (coarse - middle));
}

}  // namespace upside_down

// Says: The order is rounded to a whole number.
// Hint: A function that is not smooth can have an order such as 1.5, and a measured 1.4 may be the first
//       sign of it. Return what you measure.
namespace whole_number {

double order_of_results(double coarse, double middle, double fine) {
    return std::round(std::log2((coarse - middle) / (middle - fine)));
}

}  // namespace whole_number

// Says: The order is half of what it should be.
// Hint: From coarse to fine the step falls to a quarter. But from the first difference to the second it only
//       falls by half.
namespace quarter_of_step {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((coarse - middle) / (middle - fine)) / 2;
}

}  // namespace quarter_of_step

// Says: Right for errors that shrink with the step. Where they grow, the order is below zero, and yours has lost
//       its sign: is its size taken, or the larger difference always divided by the smaller?
// Hint: The ratio of the first difference to the second is above zero already, and has a logarithm. Its sign says
//       something.
namespace without_sign {

double order_of_results(double coarse, double middle, double fine) {
    return std::fabs(std::log2((coarse - middle) / (middle - fine)));
}

}  // namespace without_sign

// Says: One too little: a power of the step is taken off, as if the differences still had to be divided by
//       their steps.
// Hint: A difference of two results falls with the same power of the step as the results' errors. Nothing
//       has to be taken off.
namespace one_too_many {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((coarse - middle) / (middle - fine)) - 1;
}

}  // namespace one_too_many

// Says: The logarithm is the one to base ten: order one would come out as 0.30.
// Hint: Ask by which power of two the error shrinks, for the step is halved.
namespace decimal_logarithm {

double order_of_results(double coarse, double middle, double fine) {
    return std::log10((coarse - middle) / (middle - fine));
}

}  // namespace decimal_logarithm

// Says: The whole way from coarse to fine is compared with its first part. For an order above zero, that ratio
//       stays between one and two.
// Hint: Leave the sum out: compare the first difference with the second.
namespace whole_over_first {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((coarse - fine) / (coarse - middle));
}

}  // namespace whole_over_first

// Says: No number comes out, as of the logarithm of something negative: are the two differences taken in opposite
//       directions? Or is one of them zero, or a minus too many?
// Hint: Middle lies between the other two. Which signs have the two differences if each goes from coarse to fine?
namespace opposite_directions {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((coarse - middle) / (fine - middle));
}

}  // namespace opposite_directions

// Says: The logarithm of one difference is divided by that of the other: that depends on the unit of the
//       results.
// Hint: Measure in millimetres, and the order must stay what it is. The logarithm of a ratio is a
//       difference of logarithms.
namespace quotient_of_logarithms {

double order_of_results(double coarse, double middle, double fine) {
    return std::log(std::fabs(coarse - middle)) / std::log(std::fabs(middle - fine));
}

}  // namespace quotient_of_logarithms

// Says: An order below zero is cut to zero.
// Hint: Where the error grows as the step shrinks, the order says so by its sign. Return what comes out.
namespace not_below_zero {

double order_of_results(double coarse, double middle, double fine) {
    return std::max(0.0, std::log2((coarse - middle) / (middle - fine)));
}

}  // namespace not_below_zero

// Says: One too much: a power of the step is added, as if the results were sums over steps.
// Hint: A difference of two results falls with the same power of the step as their errors do. Return that
//       power as it is.
namespace one_too_few {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2((coarse - middle) / (middle - fine)) + 1;
}

}  // namespace one_too_few

// Says: Only results that fall get an order: where they rise, both differences are negative, and that is taken for a fault.
// Hint: The quotient of two negative differences is positive. Look at its sign, not at theirs.
namespace only_falling {

double order_of_results(double coarse, double middle, double fine) {
    if (coarse <= middle || middle <= fine) return 0;
    return std::log2((coarse - middle) / (middle - fine));
}

}  // namespace only_falling

// Says: Each difference has a logarithm of its own, and where the results rise, both are negative: there is no such
//       logarithm.
// Hint: Take the logarithm of the quotient, which is positive either way, or of both sizes.
namespace no_absolute_of_falling {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2(coarse - middle) - std::log2(middle - fine);
}

}  // namespace no_absolute_of_falling

// Says: Each difference has a logarithm of its own, and where the results fall, both are negative: there is no such
//       logarithm.
// Hint: The quotient of two negative numbers is positive: divide first.
namespace no_absolute_of_rising {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2(middle - coarse) - std::log2(fine - middle);
}

}  // namespace no_absolute_of_rising

// Says: This is half of the quotient of the differences. It is right for an error that shrinks to a quarter, by
//       chance.
// Hint: The quotient is 2 to the power of the order. What finds an exponent?
namespace half_of_the_ratio {

double order_of_results(double coarse, double middle, double fine) {
    return (coarse - middle) / (middle - fine) / 2;
}

}  // namespace half_of_the_ratio

// Says: The quotients of the results themselves are compared, where those of their differences belong.
// Hint: Shift all three results by the same amount: the order must stay. What of yours stays?
namespace results_for_differences {

double order_of_results(double coarse, double middle, double fine) {
    return std::log2(std::fabs((coarse / middle) / (middle / fine)));
}

}  // namespace results_for_differences

// Says: Each difference is divided by a result. Then the order hangs on where zero is: add the same to all
//       three, and another comes out.
// Hint: The error is a difference of results. In their quotient the unit is gone already.
namespace relative_differences {

double order_of_results(double coarse, double middle, double fine) {
    const double before = (coarse - middle) / coarse, after = (middle - fine) / middle;
    return std::log2(std::fabs(before / after));
}

}  // namespace relative_differences
