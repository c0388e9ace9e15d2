#include "exercise.hpp"

// The course's answer, but for the error, and for the factor that is made of it.
static double limited(double error, double h, double factor) {
    if (!std::isfinite(error)) return h / 5;
    return error == 0 ? 5 * h : h * std::clamp(factor, 0.2, 5.0);
}

// Says: The exponent is 1 / order. That belongs to the error of a whole run; a single step has one power more.
// Hint: One step is off by C h^(order + 1). Put the next step in, and divide the two errors.
namespace exponent_of_order {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 1.0 / order));
}

}  // namespace exponent_of_order

// Says: This takes a square root for every order, as the chapter's code does for implicit Euler.
// Hint: Where does the 2 of a square root come from? Implicit Euler has order one.
namespace always_a_root {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 0.5));
}

}  // namespace always_a_root

// Says: The exponent is zero, so every factor is 0.9: in C++ 1 / (order + 1) is a division of whole numbers.
// Hint: Write 1.0.
namespace whole_number_division {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * std::pow(tolerance / error, static_cast<double>(1 / (order + 1))));
}

}  // namespace whole_number_division

// Says: The difference of the two results is taken for the error of the halves. It is larger, the more so the higher
//       the order.
// Hint: The whole step is off too, and by 2^order times as much. What is their difference then?
namespace difference_is_error {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 1.0 / (order + 1)));
}

}  // namespace difference_is_error

// Says: This is the error of the whole step. The tolerance is for the two halves.
// Hint: How many times better are the halves than the whole step?
namespace error_of_whole {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) * std::exp2(order) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 1.0 / (order + 1)));
}

}  // namespace error_of_whole

// Says: The halves are taken for 2^(order + 1) times better than the whole step. That is true of one half; there are
//       two.
// Hint: The errors of both halves add up.
namespace power_too_many {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order + 1) - 1);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 1.0 / (order + 1)));
}

}  // namespace power_too_many

// Says: A large error makes the step longer: the quotient is upside down.
// Hint: With an error of twice the tolerance the step has to shrink. Is your factor below one?
namespace upside_down {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * std::pow(error / tolerance, 1.0 / (order + 1)));
}

}  // namespace upside_down

// Says: The limits are missing: the step grows and shrinks as far as it likes.
// Hint: std::clamp(factor, low, high) keeps a number between two others.
namespace no_limits {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    if (error == 0) return 5 * h;
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * factor;
}

}  // namespace no_limits

// Says: The step may shrink by as much as it likes: only one of the limits is there.
// Hint: Neither more than 5 h nor less than h / 5.
namespace only_grows_slowly {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    if (error == 0) return 5 * h;
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * std::min(factor, 5.0);
}

}  // namespace only_grows_slowly

// Says: You keep the step between 0.2 and 5 seconds. The limits are for how it changes.
// Hint: Clamp the factor first, and multiply by h then.
namespace limits_in_seconds {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    if (error == 0) return 5 * h;
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return std::clamp(h * factor, 0.2, 5.0);
}

}  // namespace limits_in_seconds

// Says: The margin is forgotten: the next step aims at the tolerance itself, and will often miss it.
// Hint: 0.9 times that step.
namespace margin_forgotten {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, std::pow(tolerance / error, 1.0 / (order + 1)));
}

}  // namespace margin_forgotten

// Says: The margin stands under the root: nine tenths of the tolerance, not of the step.
// Hint: Take the power first. The 0.9 is for the step.
namespace margin_under_the_root {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, std::pow(0.9 * tolerance / error, 1.0 / (order + 1)));
}

}  // namespace margin_under_the_root

// Says: The margin comes after the limits: the step grows to 4.5 times at most, and may shrink below a fifth.
// Hint: The limits have the last word. Clamp at the very end.
namespace margin_after_limits {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    if (error == 0) return 5 * h;
    const double factor = std::pow(tolerance / error, 1.0 / (order + 1));
    return 0.9 * h * std::clamp(factor, 0.2, 5.0);
}

}  // namespace margin_after_limits

// Says: Results that are not numbers make the step five times as long. Every comparison with NaN is false: so
//       std::min(5.0, NaN) is 5, and !(error > 0) is true.
// Hint: An input was NaN here, and the task tells what to return then. Ask std::isfinite before you compare anything.
namespace not_a_number_grows {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * std::max(0.2, std::min(5.0, factor));
}

}  // namespace not_a_number_grows

// Says: Results that are not numbers make a step that is not a number: std::clamp hands NaN through, and so do
//       comparisons, which are all false.
// Hint: An input was NaN here, and the task tells what to return then. std::isfinite tells such results from numbers.
namespace not_a_number_stays {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * std::clamp(factor, 0.2, 5.0);
}

}  // namespace not_a_number_stays

// Says: NaN among the arguments is seen, but two infinite results of one sign are not: infinity minus infinity is NaN
//       as well.
// Hint: Look at the difference, or ask std::isfinite of both results.
namespace infinity_unseen {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (std::isnan(whole) || std::isnan(halves)) return h / 5;
    if (error == 0) return 5 * h;
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * std::clamp(factor, 0.2, 5.0);
}

}  // namespace infinity_unseen

// Says: Where the two results agree the step stays as it is: a body at rest would be followed in tiny steps for ever.
// Hint: What does the task say of results that agree to the last bit?
namespace no_error_no_change {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    if (error == 0) return h;
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * std::clamp(factor, 0.2, 5.0);
}

}  // namespace no_error_no_change

// Says: The difference has kept its sign: where the halves are larger, a root of a negative number is taken.
// Hint: An error has a size. std::fabs.
namespace signed_difference {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = (whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 1.0 / (order + 1)));
}

}  // namespace signed_difference

// Says: The error is divided by the result. This tolerance has the unit of the results, and is not a part of them.
// Hint: Try it with results near zero, and with both of them moved by the same amount.
namespace relative {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1) / std::fabs(halves);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 1.0 / (order + 1)));
}

}  // namespace relative

// Says: The difference has lost its digits: the results have gone through float before it was taken.
// Hint: A small difference of two large numbers is where float hurts most. Stay with double.
namespace single_precision {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error =
        std::fabs(static_cast<float>(whole) - static_cast<float>(halves)) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * std::pow(tolerance / error, 1.0 / (order + 1)));
}

}  // namespace single_precision

// Says: A negative difference counts as a perfect step: where the halves are larger than the whole, the step grows,
//       however large the error.
// Hint: Too large or too small, both are off. Which function takes the sign away?
namespace negative_is_perfect {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = (whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    if (error <= 0) return 5 * h;
    return h * std::clamp(0.9 * std::pow(tolerance / error, 1.0 / (order + 1)), 0.2, 5.0);
}

}  // namespace negative_is_perfect

// Says: This is the chapter's code, for a method of order one: a square root of the plain difference, whatever the
//       order.
// Hint: For order p the halves are off by less than the difference, and the root is another one. The line about C
//       h^(order + 1) tells both.
namespace as_in_the_chapter {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves);
    return limited(error, h, 0.9 * std::sqrt(tolerance / error));
}

}  // namespace as_in_the_chapter

// Says: The factor follows the tolerance without any root, as if the error grew like the step.
// Hint: Twice the step has 2^(order + 1) times the error. Solve that for the step.
namespace no_root {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    return limited(error, h, 0.9 * tolerance / error);
}

}  // namespace no_root

// Says: This is the factor by which the step should change, and not the step.
// Hint: A step has seconds. How long was the last one?
namespace factor_alone {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return 0.2;
    if (error == 0) return 5;
    return std::clamp(0.9 * std::pow(tolerance / error, 1.0 / (order + 1)), 0.2, 5.0);
}

}  // namespace factor_alone

// Says: Two results that are the same infinity count as agreeing, and the step grows. They agree in having blown up.
// Hint: Ask first whether both are finite, and then whether they are the same.
namespace infinities_agree {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    if (whole == halves) return 5 * h;
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    return h * std::clamp(0.9 * std::pow(tolerance / error, 1.0 / (order + 1)), 0.2, 5.0);
}

}  // namespace infinities_agree

// Says: Every step is followed by one of 0.09 s, as in the example.
// Hint: Begin with the error of the halves, from the difference.
namespace example {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    return 0.09;
}

}  // namespace example

// Says: Results that are huge are taken for results that are not finite, even where they agree to the last bit.
// Hint: The results may have any size. What does std::isfinite say of 1e300?
namespace huge_is_not_finite {

double next_step(double whole, double halves, double h, double tolerance, int order) {
    if (!(std::fabs(whole) < 1e30 && std::fabs(halves) < 1e30)) return h / 5;
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (error == 0) return 5 * h;
    return h * std::clamp(0.9 * std::pow(tolerance / error, 1.0 / (order + 1)), 0.2, 5.0);
}

}  // namespace huge_is_not_finite
