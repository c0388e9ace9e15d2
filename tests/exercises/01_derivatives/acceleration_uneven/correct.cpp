#include "exercise.hpp"

namespace parabola {

// The parabola x1 + v s + a s²/2 through all three: for v and a, two equations, at s = −h0 and h1.
double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const double back = x0 - x1, ahead = x2 - x1;
    const double determinant = h0 * h1 * (h0 + h1);
    return 2 * (ahead * h0 + back * h1) / determinant;
}

}  // namespace parabola

namespace weights {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const double sum = h0 + h1;
    return 2 * x0 / (h0 * sum) - 2 * x1 / (h0 * h1) + 2 * x2 / (h1 * sum);
}

}  // namespace weights
