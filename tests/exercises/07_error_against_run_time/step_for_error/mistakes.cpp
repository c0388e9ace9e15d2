#include "exercise.hpp"

// Says: The quotient of the errors is upside down: who wants less error gets a longer step.
// Hint: Put the example in: the wanted error is smaller than the measured one. Is your step shorter?
namespace upside_down {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::pow(error / wanted, 1.0 / order);
}

}  // namespace upside_down

// Says: The exponent is 1 / (order + 1). That belongs to the error of a single step; this is the error of a
//       whole run.
// Hint: A run takes the more steps the shorter they are, and that takes one power away: C h^order.
namespace power_too_many {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::pow(wanted / error, 1.0 / (order + 1));
}

}  // namespace power_too_many

// Says: From order two on the step stays as it was: in C++ 1 / order is a division of whole numbers, and
//       gives zero.
// Hint: One of the two numbers must be a double.
namespace whole_number_division {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::pow(wanted / error, 1 / order);
}

}  // namespace whole_number_division

// Says: You have raised to the order, where its root was to be taken: with order four a tenth of the error
//       would need a ten thousandth of the step.
// Hint: The error is a power of the step. Then what is the step of the error?
namespace power_for_root {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::pow(wanted / error, order);
}

}  // namespace power_for_root

// Says: The step shrinks as the error does. That is so with order one only; yours does not look at the
//       order.
// Hint: With order two, what does half the step do to the error? Then you need less than half for half the
//       error, or more?
namespace proportional {

double step_for_error(double error, double h, int order, double wanted) {
    return h * wanted / error;
}

}  // namespace proportional

// Says: This takes a square root whatever the order is.
// Hint: A square root is for order two. Which exponent is a square root, and which one does order three
//       need?
namespace always_a_root {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::sqrt(wanted / error);
}

}  // namespace always_a_root

// Says: You have divided by the order, instead of taking a root: with order two half the error would need a
//       quarter of the step, and even the same error half of it.
// Hint: If nothing more is wanted than was measured, the step must stay. A quotient of one stays one under a
//       root.
namespace divided {

double step_for_error(double error, double h, int order, double wanted) {
    return h * wanted / (error * order);
}

}  // namespace divided

// Says: The step is never made longer, even where much more error is allowed. That wastes what this is all
//       about.
// Hint: A looser wish needs a longer step by the same formula. No comparison is needed.
namespace never_longer {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::min(1.0, std::pow(wanted / error, 1.0 / order));
}

}  // namespace never_longer

// Says: The step changes to a fifth at least and to five times at most. That is for a controller, which must
//       not trust the error of one step too far; here the law is given for all steps.
// Hint: Leave out the limits.
namespace limits_of_a_controller {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::clamp(std::pow(wanted / error, 1.0 / order), 0.2, 5.0);
}

}  // namespace limits_of_a_controller

// Says: You have kept a margin of a tenth. That is wise in a controller, but the question here is for the
//       step that is off by just what is wanted.
// Hint: What must come out where the wanted error is the one that was measured?
namespace margin {

double step_for_error(double error, double h, int order, double wanted) {
    return 0.9 * h * std::pow(wanted / error, 1.0 / order);
}

}  // namespace margin

// Says: You halve or double the step until it fits. That finds one of the steps h, h/2, h/4 and so on, and
//       not the one in between that is just right.
// Hint: The error follows a formula. Solve it for the step, and no search is needed.
namespace by_doubling {

double step_for_error(double error, double h, int order, double wanted) {
    while (error > wanted) {
        h /= 2;
        error /= std::exp2(order);
    }
    while (error * std::exp2(order) <= wanted) {
        h *= 2;
        error *= std::exp2(order);
    }
    return h;
}

}  // namespace by_doubling

// Says: This is how many times longer the step must be, and not the step.
// Hint: Two runs with other steps and the same two errors would get the same answer from you. What have you
//       not used?
namespace factor_alone {

double step_for_error(double error, double h, int order, double wanted) {
    return std::pow(wanted / error, 1.0 / order);
}

}  // namespace factor_alone

// Says: The answer is right to seven digits only: somewhere it goes through float.
// Hint: std::powf and float lose half of the digits. Stay with double.
namespace single_precision {

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::pow(float(wanted / error), 1.0f / float(order));
}

}  // namespace single_precision

// Says: C is the error over h, whatever the order. For order two it is the error over h squared.
// Hint: The error is C h^order. Put the run that you know in: what is C?
namespace constant_of_order_one {

double step_for_error(double error, double h, int order, double wanted) {
    const double constant = error / h;
    return std::pow(wanted / constant, 1.0 / order);
}

}  // namespace constant_of_order_one

// Says: The step is never made shorter, even where less error is wanted.
// Hint: Is there a std::max in your answer? Who wants less error needs a shorter step.
namespace never_shorter {

double step_for_error(double error, double h, int order, double wanted) {
    return std::max(h, h * std::pow(wanted / error, 1.0 / order));
}

}  // namespace never_shorter

// Says: Whatever is asked, the step is that of the example.
// Hint: How does the error grow with the step? Begin with the quotient of the two errors.
namespace example {

double step_for_error(double error, double h, int order, double wanted) {
    return 0.005;
}

}  // namespace example

// Says: The step that was given comes back, whatever the errors and the order are.
// Hint: Is there a 1/4 or 1/2 in your exponent? In C++ that is a division of whole numbers, and any number to the power
//       zero is one.
namespace step_kept {

double step_for_error(double error, double h, int order, double wanted) {
    return h;
}

}  // namespace step_kept

// Says: The root is taken of the wanted error alone, and the error that was found is divided by as it is.
// Hint: Both errors are C h to the order. What of their quotient?
namespace root_of_the_wanted {

double step_for_error(double error, double h, int order, double wanted) {
    return h / error * std::pow(wanted, 1.0 / order);
}

}  // namespace root_of_the_wanted
