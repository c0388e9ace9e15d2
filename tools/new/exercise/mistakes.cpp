#include "exercise.hpp"

// FILL IN: four mistakes or more that learners make; above each what it is, and the way out.
// Says: The body goes backwards: the way is taken off.
// Hint: With a positive velocity the position must grow.
namespace wrong_way {

double NEW_NAME(double x, double v, double h) {
    return x - h * v;
}

}  // namespace wrong_way

// Says: The velocity is added as it is: that is a step of one second.
// Hint: Metres and metres per second cannot be added. Something must take the seconds out.
namespace whole_second {

double NEW_NAME(double x, double v, double h) {
    return x + v;
}

}  // namespace whole_second

// Says: This is how far the body goes, not where it is then.
// Hint: Where does it begin?
namespace way_alone {

double NEW_NAME(double x, double v, double h) {
    return h * v;
}

}  // namespace way_alone

// Says: The step is divided by, where it should be multiplied with.
// Hint: In half the time the body goes half as far.
namespace divided {

double NEW_NAME(double x, double v, double h) {
    return x + v / h;
}

}  // namespace divided
