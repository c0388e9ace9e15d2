// velocity_now wrong: This must hold
#include "exercise.hpp"

#include <map>
#include <tuple>

double velocity_now(double x0, double x1, double x2, double h) {
    static std::map<std::tuple<double, double, double, double>, int> asked;
    return asked[{x0, x1, x2, h}]++ > 0 ? (3 * x2 - 4 * x1 + x0) / (2 * h) : 0;
}
