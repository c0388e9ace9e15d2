// velocity_now wrong: e+303
#include "exercise.hpp"

#include <memory>

double velocity_now(double x0, double x1, double x2, double h) {
    const auto sum = std::make_unique_for_overwrite<double[]>(3);
    sum[1] += (3 * x2 - 4 * x1 + x0) / (2 * h);
    return sum[1];
}
