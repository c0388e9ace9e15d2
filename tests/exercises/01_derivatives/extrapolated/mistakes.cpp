#include "exercise.hpp"

// Says: This is right when the fine step is half of the coarse one, and takes no notice of the ratio
//       otherwise.
// Hint: With a third of the step, an error of order one falls to a third, and one of order two to a ninth.
//       What takes the place of the two?
namespace always_half {

double extrapolated(double coarse, double fine, double ratio, int order) {
    const double shrinks = std::pow(2, order);
    return fine + (fine - coarse) / (shrinks - 1);
}

}  // namespace always_half

// Says: This treats every formula as if it had order one: the errors are taken to be in the ratio of the
//       steps.
// Hint: A formula of order two that takes half the step has a quarter of the error. Which power of the ratio
//       do you need?
namespace order_one {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine + (fine - coarse) / (ratio - 1);
}

}  // namespace order_one

// Says: The difference of the results is divided by how many times smaller the fine error is. Then some of
//       the error stays.
// Hint: The difference of the two results is not the coarse error. It is the coarse error less the fine one.
namespace forgot_one {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine + (fine - coarse) / std::pow(ratio, order);
}

}  // namespace forgot_one

// Says: The correction has the wrong sign, so the answer has twice the fine result's error and not none of
//       it.
// Hint: Going from the coarse result to the fine one, you approach the exact value, and have not yet reached
//       it. Which way do you go on?
namespace away {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine - (fine - coarse) / (std::pow(ratio, order) - 1);
}

}  // namespace away

// Says: The answer goes on beyond the coarse result, away from the exact value: are coarse and fine interchanged,
//       or does the power of the ratio stand upside down?
// Hint: How many times as large as the fine error is the coarse one? Is that number above one in your formula, and
//       do you start from the better result?
namespace swapped {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return coarse + (coarse - fine) / (std::pow(ratio, order) - 1);
}

}  // namespace swapped

// Says: This is the mean of the two results. Both err to the same side, so their mean does too.
// Hint: Errors of the same sign cancel only when one result has a negative weight. The two weights must
//       still add up to one.
namespace mean {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return (coarse + fine) / 2;
}

}  // namespace mean

// Says: This is the correction alone: the error of the fine result, with the sign turned round.
// Hint: Two equal results need no correction, and then the answer must be those results and not zero.
namespace correction_alone {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return (fine - coarse) / (std::pow(ratio, order) - 1);
}

}  // namespace correction_alone

// Says: The ratio is multiplied by the order. It should be raised to the power of the order.
// Hint: Ratio 2 and order 2 hide this, for two times two is two to the power of two. Write down the errors
//       for the ratio 3 and the order 2.
namespace times_order {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine + (fine - coarse) / (ratio * order - 1);
}

}  // namespace times_order

// Says: The power is one too high: this cancels the error after the leading one, and leaves the leading one.
// Hint: A formula of order p has an error that falls with the power p of the step, and not p + 1.
namespace next_order {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine + (fine - coarse) / (std::pow(ratio, order + 1) - 1);
}

}  // namespace next_order

// Says: This is (4 fine - coarse) / 3, whatever the ratio and the order: it is right for half the step and
//       order two.
// Hint: The 4 and the 3 come from two to the power of two. Write them with the ratio and the order that are
//       handed over.
namespace half_and_two {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return (4 * fine - coarse) / 3;
}

}  // namespace half_and_two

// Says: Base and exponent are interchanged: the order is raised to the power of the ratio.
// Hint: With order one, one to any power is one, and your divisor is zero. What has to be multiplied by
//       itself, and how many times?
namespace base_and_exponent {

double extrapolated(double coarse, double fine, double ratio, int order) {
    const double shrinks = std::pow(order, ratio);
    return fine + (fine - coarse) / (shrinks - 1);
}

}  // namespace base_and_exponent

// Says: The correction is that of the fine result, but it is added to the coarse one.
// Hint: The size of the correction and the result that it belongs to go together: how far is each of the
//       two from the exact value?
namespace added_to_coarse {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return coarse + (fine - coarse) / (std::pow(ratio, order) - 1);
}

}  // namespace added_to_coarse

// Says: You take the coarse result's error away from the fine one, which has much less of it.
// Hint: The two errors are in the ratio that you found. Which of them has the fine result?
namespace coarse_error_taken {

double extrapolated(double coarse, double fine, double ratio, int order) {
    const double shrinks = std::pow(ratio, order);
    return fine + (fine - coarse) * shrinks / (shrinks - 1);
}

}  // namespace coarse_error_taken

// Says: The divisor is the power plus one, where it has to be the power less one.
// Hint: The coarse error less the fine one is what you can see. How many fine errors are that?
namespace plus_one {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine + (fine - coarse) / (std::pow(ratio, order) + 1);
}

}  // namespace plus_one

// Says: Both results have a positive weight: this is a mean of the two, which lies between them.
// Hint: Both results err to the same side, and the exact value lies beyond the better one. One of the
//       weights must be negative.
namespace weighted_mean {

double extrapolated(double coarse, double fine, double ratio, int order) {
    const double shrinks = std::pow(ratio, order);
    return (shrinks * fine + coarse) / (shrinks + 1);
}

}  // namespace weighted_mean

// Says: The ratio is squared, whatever the order is.
// Hint: Only for order two do the errors go with the square of the step. Which argument have you not used?
namespace order_two {

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine + (fine - coarse) / (ratio * ratio - 1);
}

}  // namespace order_two

// Says: The power of the ratio is kept as a whole number: what it has behind the point is lost.
// Hint: The ratio need not be whole. Look at the type of each variable that holds it or a power of it.
namespace whole_ratio {

double extrapolated(double coarse, double fine, double ratio, int order) {
    const double shrinks = static_cast<int>(std::pow(ratio, order));
    return fine + (fine - coarse) / (shrinks - 1);
}

}  // namespace whole_ratio

// Says: The power of the ratio is one too low.
// Hint: An error of order one shrinks by the ratio itself. What do you have in its place for order one?
namespace power_one_less {

double extrapolated(double coarse, double fine, double ratio, int order) {
    double shrinks = 1;
    for (int i = 1; i < order; ++i) shrinks *= ratio;
    return shrinks == 1 ? fine : fine + (fine - coarse) / (shrinks - 1);
}

}  // namespace power_one_less
