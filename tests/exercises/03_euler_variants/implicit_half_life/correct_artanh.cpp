#include "exercise.hpp"

// The logarithm of 1 + u is twice the area tangent of u / (2 + u), which loses no digits either.
double implicit_half_life(double omega, double h) {
    const double u = omega * omega * h * h;
    const double shrinks = std::atanh(u / (2 + u));  // the logarithm, per step
    const double per_second = shrinks / h;
    return std::log(2.0) / per_second;
}
