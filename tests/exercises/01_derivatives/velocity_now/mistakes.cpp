#include "exercise.hpp"

// Says: This is the backward difference of the last two frames: the velocity of half a step ago.
// Hint: It has order one. The frame before holds what is missing: how fast the slope itself changes.
namespace two_frames {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - x1) / h;
}

}  // namespace two_frames

// Says: This is the central difference: the velocity at the middle frame, one step ago.
// Hint: Velocity is asked at the newest frame, the last argument of the three.
namespace middle {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - x0) / (2 * h);
}

}  // namespace middle

// Says: The weights are right, but nothing divides by the step.
// Hint: Positions are metres and the answer is metres per second: something must bring in the seconds.
namespace forgot_h {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / 2;
}

}  // namespace forgot_h

// Says: This is the velocity at the oldest frame: the formula looks the wrong way.
// Hint: Reverse the roles of x0 and x2. Running time backwards changes the sign of a velocity, too.
namespace oldest_frame {

double velocity_now(double x0, double x1, double x2, double h) {
    return (-3 * x0 + 4 * x1 - x2) / (2 * h);
}

}  // namespace oldest_frame

// Says: The newer slope is corrected by the whole change between the two slopes, which is the velocity half
//       a step ahead.
// Hint: The two slopes belong to moments one step apart, but from the newer one to now is only half a step.
namespace half_too_much {

double velocity_now(double x0, double x1, double x2, double h) {
    return (2 * x2 - 3 * x1 + x0) / h;
}

}  // namespace half_too_much

// Says: The weights are right, but / 2 * h divides by two and then multiplies by the step.
// Hint: C++ reads / and * from left to right. Put brackets round what is to stand below the line.
namespace missing_brackets {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / 2 * h;
}

}  // namespace missing_brackets

// Says: On paper it is right, but 3/2 is 1 and 1/2 is 0 in C++, where whole numbers divide into whole
//       numbers.
// Hint: Write 1.5 and 0.5. Or divide by two at the end, when a double stands above the line.
namespace whole_numbers {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 / 2 * x2 - 2 * x1 + 1 / 2 * x0) / h;
}

}  // namespace whole_numbers
